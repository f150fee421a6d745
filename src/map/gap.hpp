// How far a place is from a box of cells.
#pragma once

#include <algorithm>
#include <cmath>

#include "waybreaker/map.hpp"

namespace waybreaker {

// From the nearest centre of a cell of the box, in cells; 0 between them.
inline double gap(const Box& box, Point to) {
    const double dx = std::max({box.min.x - to.x, to.x - box.max.x, 0.0});
    const double dy = std::max({box.min.y - to.y, to.y - box.max.y, 0.0});
    return std::sqrt(dx * dx + dy * dy);
}

}  // namespace waybreaker
