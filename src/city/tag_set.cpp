#include "city/tag_set.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

namespace waybreaker::city {
namespace {

bool same_letters(std::string_view a, std::string_view b) {
    return std::ranges::equal(
        a, b, {}, [](unsigned char c) { return std::tolower(c); }, [](unsigned char c) { return std::tolower(c); });
}

}  // namespace

const std::string* TagSet::find(std::string_view key) const {
    const auto found = std::find_if(tags_.begin(), tags_.end(), [&](const auto& tag) {
        return letters_ == Case::matters ? tag.first == key : same_letters(tag.first, key);
    });
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

bool TagSet::matches_any(const std::vector<TagFilter>& filters) const {
    return std::ranges::any_of(filters, [this](const TagFilter& one) { return one.key == "*" || matches(one); });
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
