#include "http/header_list.hpp"

#include <algorithm>

namespace waybreaker::http {
namespace {

char lower(char c) {
    return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c;
}

}  // namespace

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t");
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

bool same_word(std::string_view one, std::string_view other) {
    return std::equal(one.begin(), one.end(), other.begin(), other.end(),
                      [](char a, char b) { return lower(a) == lower(b); });
}

std::vector<std::string> header_list(std::string_view value) {
    std::vector<std::string> items;
    while (true) {
        const std::size_t comma = value.find(',');
        std::string item(trimmed(value.substr(0, comma)));
        std::transform(item.begin(), item.end(), item.begin(), lower);
        if (!item.empty()) items.push_back(std::move(item));
        if (comma == std::string_view::npos) return items;
        value.remove_prefix(comma + 1);
    }
}

}  // namespace waybreaker::http
