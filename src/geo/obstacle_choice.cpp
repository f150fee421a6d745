#include "geo/obstacle_choice.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "waybreaker/error.hpp"

namespace waybreaker::geo {

bool TagFilter::accepts(const std::string& value) const {
    return value != "no" && (values.empty() || std::find(values.begin(), values.end(), value) != values.end());
}

TagFilter parse_tag_filter(const std::string& text) {
    const std::size_t equals = std::min(text.find('='), text.size());
    TagFilter filter{.key = text.substr(0, equals)};
    const bool quote = filter.key.find_first_of("\"'\\") != std::string::npos;
    for (std::size_t begin = equals + 1; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        filter.values.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    if (filter.key.empty() || quote || std::count(filter.values.begin(), filter.values.end(), "") > 0) {
        throw InputError("'" + text + "' is no filter for tags: KEY or KEY=VALUE,... such as barrier=wall,fence");
    }
    return filter;
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
        throw InputError("'" + text + "' is no quantity: area or a tag, with *FACTOR if it is to be scaled");
    }
    return quantity;
}

bool ObstacleChoice::wants_lines() const {
    return std::any_of(obstacles.begin(), obstacles.end(),
                       [](const TagFilter& filter) { return filter.key != "building"; });
}

}  // namespace waybreaker::geo
