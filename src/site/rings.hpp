// The edges of labelled areas as closed rings along the sides of cells.
#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "waybreaker/cell.hpp"

namespace waybreaker::site {

// Labels row by row, 0 = free.
struct LabelRaster {
    int width;
    int height;
    std::span<const std::uint32_t> labels;
};

struct LabelRing {
    std::uint32_t label;
    // Where it turns, in order, with the label at its right hand, so that y down an outer ring runs clockwise. Corner
    // (x, y) is the upper-left one of cell (x, y). The first is the first one in scan order, and is not repeated.
    std::span<const Cell> corners;
};

// Gives `take` every ring, in scan order of their first corners; `corners` is good until it returns. Where cells of one
// label meet at a corner only, the ring stays with the cells that touch by a side. Time O(cells).
void trace_rings(const LabelRaster& raster, const std::function<void(const LabelRing&)>& take);

}  // namespace waybreaker::site
