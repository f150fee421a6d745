// Which features of map data are obstacles, which of them are destructible, and what their removal costs.
#pragma once

#include <string>
#include <vector>

#include "site/tag_filter.hpp"

namespace waybreaker::city {

using site::parse_tag_filters;
using site::TagFilter;

// A number of each obstacle: its area in the window, in square metres, or what a tag says, times a factor.
struct Quantity {
    std::string of;  // "area", or a tag; empty: not asked for
    double factor = 1;
};

// Throws InputError unless the text is NAME or NAME*FACTOR.
Quantity parse_quantity(const std::string& text);

struct ObstacleChoice {
    std::vector<TagFilter> obstacles = {};     // empty: buildings, and all polygons where nothing says what is one
    std::vector<TagFilter> destructible = {};  // empty: all
    std::vector<TagFilter> protect = {};       // never destructible
    std::vector<TagFilter> shelter = {};       // neither, where nothing above says what is; need not match anything
    // What areas and points say in the place of the buildings there: see premises.hpp.
    std::vector<TagFilter> premises = {};
    bool only_in_the_way = false;  // of buildings: without roofs on posts, bridges, what is underground
    Quantity weight = {};          // 1 where the tag says no number above 0
    Quantity breach_time = {};     // 0 where the tag says no number
    double wall_width = 0;         // of features that are lines, in metres; at least a cell
    std::string layer = {};        // of the source, the only one that is read for obstacles; empty: all

    // Whether lines can be obstacles; buildings are areas.
    bool wants_lines() const;
};

}  // namespace waybreaker::city
