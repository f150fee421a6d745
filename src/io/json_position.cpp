#include "io/json_position.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <set>
#include <vector>

namespace waybreaker::io {
namespace {

constexpr std::string_view space = " \t\r\n";

std::size_t skip_space(std::string_view text, std::size_t at) {
    return std::min(text.find_first_not_of(space, at), text.size());
}

// Behind the string that begins here.
std::size_t skip_string(std::string_view text, std::size_t at) {
    for (++at; at < text.size() && text[at] != '"'; ++at) {
        if (text[at] == '\\') ++at;
    }
    return std::min(at + 1, text.size());
}

// Calls visit(byte) for what is no string, until it gives true; gives that byte, or the end.
template <class Visit>
std::size_t find_outside_strings(std::string_view text, std::size_t at, Visit visit) {
    while (at < text.size()) {
        if (text[at] == '"') {
            at = skip_string(text, at);
        } else if (visit(at)) {
            return at;
        } else {
            ++at;
        }
    }
    return text.size();
}

bool opens(char c) {
    return c == '[' || c == '{';
}
bool closes(char c) {
    return c == ']' || c == '}';
}

// The comma or bracket that ends the value in which a byte lies.
std::size_t skip_value(std::string_view text, std::size_t at) {
    int depth = 0;
    return find_outside_strings(text, at, [&](std::size_t byte) {
        const char c = text[byte];
        if (opens(c)) ++depth;
        return (closes(c) && depth-- == 0) || (c == ',' && depth == 0);
    });
}

std::size_t item_at(std::string_view text, std::size_t array, std::size_t index) {
    std::size_t at = array + 1;
    while (index-- > 0) at = skip_value(text, at) + 1;
    return skip_space(text, at);
}

std::size_t member_at(std::string_view text, std::size_t object, std::string_view name) {
    const std::size_t colon = skip_space(text, skip_string(text, name_at(text, object, name)));
    return skip_space(text, colon + 1);
}

}  // namespace

std::string file_position(const std::string& file, std::string_view text, std::size_t byte) {
    const std::string_view before = text.substr(0, byte);
    const std::string_view line = before.substr(before.rfind('\n') + 1);  // all of it if there is none
    const auto begins_character = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; };
    const auto lines = std::count(before.begin(), before.end(), '\n');
    const auto characters = std::count_if(line.begin(), line.end(), begins_character);
    return file + ":" + std::to_string(lines + 1) + ":" + std::to_string(characters + 1);
}

std::size_t value_at(std::string_view text, std::string_view place) {
    std::size_t at = skip_space(text, 0);
    while (!place.empty()) {
        if (place.front() == '[') {
            std::size_t index = 0;
            std::from_chars(place.data() + 1, place.data() + place.size(), index);
            at = item_at(text, at, index);
            place.remove_prefix(place.find(']') + 1);
        } else {
            if (place.front() == '.') place.remove_prefix(1);
            const std::string_view name = place.substr(0, place.find_first_of(".["));
            at = member_at(text, at, name);
            place.remove_prefix(name.size());
        }
    }
    return at;
}

std::size_t name_at(std::string_view text, std::size_t object, std::string_view name) {
    std::size_t at = object;
    do {
        at = skip_space(text, at + 1);
        const std::size_t end = skip_string(text, at);
        if (nlohmann::json::parse(text.substr(at, end - at)) == name) return at;
        at = skip_value(text, end);
    } while (at < text.size() && text[at] == ',');
    return object;
}

std::size_t depth_at(std::string_view text, int most_levels) {
    int depth = 0;
    return find_outside_strings(text, 0, [&](std::size_t byte) {
        if (closes(text[byte])) --depth;
        return opens(text[byte]) && ++depth > most_levels;
    });
}

std::optional<RepeatedName> repeated_name(std::string_view text) {
    struct Level {
        bool is_object;
        std::set<std::string> names;
    };
    std::vector<Level> levels;
    bool name_follows = false;
    for (std::size_t at = 0; at < text.size(); ++at) {
        const char c = text[at];
        if (c == '"') {
            const std::size_t end = skip_string(text, at);
            if (name_follows) {
                const std::string name = nlohmann::json::parse(text.substr(at, end - at)).get<std::string>();
                if (!levels.back().names.insert(name).second) return RepeatedName{at, name};
            }
            name_follows = false;
            at = end - 1;
        } else if (opens(c)) {
            levels.push_back({c == '{', {}});
            name_follows = c == '{';
        } else if (closes(c)) {
            levels.pop_back();
            name_follows = false;
        } else if (c == ',') {
            name_follows = levels.back().is_object;
        }
    }
    return std::nullopt;
}

std::size_t overflow_at(std::string_view text) {
    const std::string copy(text);  // strtod reads to a null
    std::size_t end = 0;
    return find_outside_strings(text, 0, [&](std::size_t byte) {
        if (byte < end || text[byte] < '0' || text[byte] > '9') return false;
        char* rest = nullptr;
        const double value = std::strtod(copy.data() + byte, &rest);
        end = std::size_t(rest - copy.data());
        return std::isinf(value);
    });
}

}  // namespace waybreaker::io
