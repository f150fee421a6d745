// Background: what a reader of the map knows a place by, beside its obstacles: streets, rails, water, green, names of
// places. Planning does not use it.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "waybreaker/cell.hpp"

namespace waybreaker::site {

struct Background {
    enum class Kind { street, rail, water, green, place };
    enum class Shape { line, area, point };

    struct Feature {
        Kind kind = Kind::street;
        std::string type = {};  // what the source calls it: primary, tram, river, park, square
        std::string name = {};  // empty where it has none
        Shape shape = Shape::line;
        // In cell units. Lines; or rings that close by themselves, each outer one before its holes, which turn the
        // other way (by the even-odd rule, too, their inside is the area); or points, one each.
        std::vector<std::vector<Point>> parts = {};
        friend bool operator==(const Feature&, const Feature&) = default;
    };

    std::vector<Feature> features = {};
    friend bool operator==(const Background&, const Background&) = default;
};

// What files call the kinds, in their order.
inline constexpr std::array<std::string_view, 5> background_kinds{"street", "rail", "water", "green", "place"};
// And the shapes.
inline constexpr std::array<std::string_view, 3> background_shapes{"line", "area", "point"};

}  // namespace waybreaker::site
