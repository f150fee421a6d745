#include "city/tag_set.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace waybreaker::city {

const std::string* TagSet::find(std::string_view key) const {
    const auto found = std::find_if(tags_.begin(), tags_.end(), [&](const auto& tag) { return tag.first == key; });
    return found == tags_.end() ? nullptr : &found->second;
}

bool TagSet::says(std::string_view key) const {
    const std::string* value = find(key);
    return value != nullptr && !site::says_no(*value);
}

bool TagSet::is(std::string_view key, std::string_view value) const {
    const std::string* said = find(key);
    return said != nullptr && *said == value;
}

bool TagSet::matches(const TagFilter& filter) const {
    const std::string* value = find(filter.key);
    return value != nullptr && filter.accepts(*value);
}

std::optional<double> TagSet::number(std::string_view key) const {
    const std::string* value = find(key);
    return value == nullptr ? std::nullopt : leading_number(*value);
}

std::optional<double> leading_number(const std::string& text) {
    double result = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), result);
    return error == std::errc() && std::isfinite(result) ? std::optional(result) : std::nullopt;
}

}  // namespace waybreaker::city
