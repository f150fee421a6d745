#include "city/obstacle_choice.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/in_quotes.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::city {

Quantity parse_quantity(const std::string& text) {
    const std::size_t star = std::min(text.find('*'), text.size());
    Quantity quantity{.of = text.substr(0, star)};
    const char* const end = text.data() + text.size();
    if (star < text.size()) {
        const auto [rest, error] = std::from_chars(text.data() + star + 1, end, quantity.factor);
        if (error != std::errc() || rest != end) quantity.factor = 0;
    }
    if (quantity.of.empty() || !std::isfinite(quantity.factor) || !(quantity.factor > 0)) {
        throw InputError(in_quotes(text) + " is no quantity: area or a tag, with *FACTOR if it is to be scaled");
    }
    return quantity;
}

bool ObstacleChoice::wants_lines() const {
    return std::any_of(obstacles.begin(), obstacles.end(),
                       [](const TagFilter& filter) { return filter.key != "building"; });
}

}  // namespace waybreaker::city
