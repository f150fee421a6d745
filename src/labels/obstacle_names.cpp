#include "labels/obstacle_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <utility>

#include "core/control_character.hpp"
#include "core/utf8.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::labels {
namespace {

constexpr std::size_t longest_name = 250;  // bytes; OpenStreetMap's values have up to 255 characters

bool continues_character(char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
}

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(' ');
    return first == std::string_view::npos ? "" : text.substr(first, text.find_last_not_of(' ') - first + 1);
}

}  // namespace

std::string clean_name(std::string_view text) {
    std::string name;
    while (!text.empty()) {
        const std::size_t control = control_length(text);
        // Those of one byte separate words; others are between the letters of one.
        if (control <= 1) name += control == 0 ? text.front() : ' ';
        text.remove_prefix(std::max<std::size_t>(control, 1));
    }
    if (!is_utf8(name)) {
        std::replace_if(
            name.begin(), name.end(), [](unsigned char c) { return c >= 0x80U; }, '?');
    }
    name = trimmed(name);
    std::size_t end = std::min(name.size(), longest_name);
    while (end < name.size() && end > 0 && continues_character(name[end])) --end;
    return std::string(trimmed(std::string_view(name).substr(0, end)));
}

std::string names_text(const site::ObstacleNames& names) {
    std::string text;
    for (std::size_t id = 1; id < names.size(); ++id) {
        const std::string name = clean_name(names[id]);
        if (!name.empty()) text += fmt::format("{}{} {}", text.empty() ? "" : "\n", id, name);
    }
    return text;
}

site::LabelNames read_names(std::string_view text, const std::string& name) {
    site::LabelNames names;
    for (std::size_t line = 1; !text.empty(); ++line) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        std::uint32_t label = 0;
        const auto [rest, error] = std::from_chars(text.data(), text.data() + end, label);
        if (error != std::errc() || label == 0 || rest == text.data() + end || *rest != ' ') {
            throw InputError(
                fmt::format("{}: line {} of its metadata item {} is no obstacle's number and name; drop the item with "
                            "'gdal_edit.py -mo {}=' or import the map anew",
                            name, line, names_item, names_item));
        }
        std::string clean = clean_name({rest, std::size_t(text.data() + end - rest)});
        if (!clean.empty()) names.emplace(label, std::move(clean));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return names;
}

}  // namespace waybreaker::labels
