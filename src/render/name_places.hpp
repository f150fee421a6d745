// Name places: where the names of places can stand beside them.
#pragma once

#include <string>
#include <vector>

#include "render/layout.hpp"
#include "waybreaker/mission.hpp"

namespace waybreaker::render {

// What stands at one place: the names of all who start or end there.
struct Name {
    Point at;
    std::string text;  // XML already
    double width;      // of the text, in pixels
    double clear;      // how far the sign of the place reaches, in pixels
};

// Of a mission's starts and goals, in the order of its agents; of many at one place the first few.
std::vector<Name> names_at_places(const Mission& mission, const Layout& layout);

// Where each begins, on its baseline: to the right of its place if possible, else to the left, below or above, so that
// it covers neither another name nor a sign and lies in the window. Letters are `pixels` high.
std::vector<Point> name_places(const std::vector<Name>& names, double pixels, Rectangle window);

// How wide text of so many letters is at most, as a rule.
double text_width(std::size_t letters, double pixels);

}  // namespace waybreaker::render
