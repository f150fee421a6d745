#include "geo/obstacle_choice.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/quoted.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::geo {

bool TagFilter::accepts(const std::string& value) const {
    return value != "no" && (values.empty() || std::find(values.begin(), values.end(), value) != values.end());
}

std::string TagFilter::text() const {
    std::string text = key;
    for (std::size_t i = 0; i < values.size(); ++i) text += (i == 0 ? "=" : ",") + values[i];
    return text;
}

std::vector<TagFilter> parse_tag_filters(const std::string& text) {
    const auto refuse = [&](const std::string& why) {
        throw InputError(quoted(text) + why + ": a filter is KEY or KEY=VALUE,... such as barrier=wall,fence");
    };
    std::vector<TagFilter> filters;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        const std::string part = text.substr(begin, end - begin);
        begin = end + 1;
        const std::size_t equals = part.find('=');
        if (equals == std::string::npos && !filters.empty() && !filters.back().values.empty()) {
            if (part == "building") {
                refuse(" takes building for a value of " + quoted(filters.back().key) +
                       "; put it first, or in an option of its own");
            }
            filters.back().values.push_back(part);
        } else {
            filters.push_back({.key = part.substr(0, equals)});
            if (equals != std::string::npos) filters.back().values.push_back(part.substr(equals + 1));
        }
        const TagFilter& filter = filters.back();
        const bool quote = filter.key.find_first_of("\"'\\") != std::string::npos;
        const bool nothing = filter.key.empty() || (!filter.values.empty() && filter.values.back().empty());
        if (quote || nothing) refuse(" is no filter for tags");
    }
    return filters;
}

Quantity parse_quantity(const std::string& text) {
    const std::size_t star = std::min(text.find('*'), text.size());
    Quantity quantity{.of = text.substr(0, star)};
    const char* const end = text.data() + text.size();
    if (star < text.size()) {
        const auto [rest, error] = std::from_chars(text.data() + star + 1, end, quantity.factor);
        if (error != std::errc() || rest != end) quantity.factor = 0;
    }
    if (quantity.of.empty() || !std::isfinite(quantity.factor) || !(quantity.factor > 0)) {
        throw InputError(quoted(text) + " is no quantity: area or a tag, with *FACTOR if it is to be scaled");
    }
    return quantity;
}

bool ObstacleChoice::wants_lines() const {
    return std::any_of(obstacles.begin(), obstacles.end(),
                       [](const TagFilter& filter) { return filter.key != "building"; });
}

}  // namespace waybreaker::geo
