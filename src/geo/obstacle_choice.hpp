// Which features of map data are obstacles, which of them are destructible, and what their removal costs.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace waybreaker::geo {

// Features by a tag: `building` is every building, `barrier=wall,fence` some barriers, `*` everything. A tag that says
// `no` does not count.
struct TagFilter {
    std::string key;
    std::vector<std::string> values = {};  // any, if empty
    bool accepts(const std::string& value) const;
    std::string text() const;  // KEY or KEY=VALUE,...
};

// One or more of KEY and KEY=VALUE,... with commas between: what follows a KEY=VALUE and has no = is another value of
// that key. Throws InputError if it is something else.
std::vector<TagFilter> parse_tag_filters(const std::string& text);

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
    bool only_in_the_way = false;              // of buildings: without roofs on posts, bridges, what is underground
    Quantity weight = {};                      // 1 where the tag says no number above 0
    Quantity breach_time = {};                 // 0 where the tag says no number
    double wall_width = 0;                     // of features that are lines, in metres; at least a cell
    std::string layer = {};                    // of the source, the only one that is read for obstacles; empty: all

    // Whether lines can be obstacles; buildings are areas.
    bool wants_lines() const;
};

}  // namespace waybreaker::geo
