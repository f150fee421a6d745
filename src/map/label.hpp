// Connected-component labelling of blocked cells (paper, section 3: "unique identifiers to all the obstacles").
#pragma once

#include <cstdint>
#include <vector>

#include "waybreaker/map.hpp"

namespace waybreaker {

// Labels row by row: 0 for free cells, else the number of the component, from 1 in scan order.
// Two passes over runs of blocked cells, joined by union-find. Time O(cells / 64 + runs), memory 4 bytes a cell and 4
// bytes a run.
std::vector<std::uint32_t> label_components(const Grid& grid, Connectivity connectivity);

}  // namespace waybreaker
