// Name places: where the names of places can stand beside them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "render/layout.hpp"
#include "waybreaker/mission.hpp"

namespace waybreaker::render {

// What is marked on the map: a place, and how far its sign reaches, in pixels.
struct Mark {
    Point at;
    double clear;
};

// What is written beside such a mark.
struct Name {
    Point at;
    std::string text;  // XML already
    double width;      // of the text, in pixels
    double clear;      // how far the sign of the place reaches, in pixels
};

// Of a mission's starts and goals, in the order of its agents: the names of all who start or end there, of many at one
// place the first few.
std::vector<Name> names_at_places(const Mission& mission, const Layout& layout);

// Where each begins, on its baseline: to the right of its place if possible, else to the left, below or above, or a
// little farther away, so that it covers neither another name nor a sign, also not those of `others`, and lies in the
// window. Empty where there is no room. Letters are `pixels` high.
std::vector<std::optional<Point>> name_places(const std::vector<Name>& names, const std::vector<Mark>& others,
                                              double pixels, Rectangle window);

// How wide text of so many letters is at most, as a rule.
double text_width(std::size_t letters, double pixels);

}  // namespace waybreaker::render
