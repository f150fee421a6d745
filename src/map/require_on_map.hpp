// Cells that a caller names.
#pragma once

#include "waybreaker/grid.hpp"

namespace waybreaker {

// Throws InputError if the cell is off the map.
void require_on_map(const Grid& grid, Cell c);

}  // namespace waybreaker
