// Places of a map by the names that people know: streets, squares, waters and obstacles.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "site/annotations.hpp"

namespace waybreaker::site {

struct NamedPlace {
    std::string name;
    std::string what;  // "street", "obstacle 17", "suburb"
    Point at;          // on the map: half-way along a street, in the middle of an obstacle or area
};

// What is called so, without regard to capital letters and accents: that alone if there is such a place; else all whose
// names begin so; else all whose names have that in them. Things of the same name are one place, of which the largest
// stands for all, a street before obstacles. In the order of their names.
struct PlacesFound {
    enum class How { exactly, begins, contains } how = How::exactly;
    std::vector<NamedPlace> places = {};
};
PlacesFound places_called(std::string_view text, const Map& map, const Annotations& annotations);

// Without capital letters and accents, for Latin, Greek and Cyrillic letters: "hauptstrasse".
std::string plain_text(std::string_view text);

}  // namespace waybreaker::site
