// Which cells of a map a zone reaches into.
#pragma once

#include <vector>

#include "waybreaker/zone.hpp"

namespace waybreaker::zones {

// The cells of a map of that size whose area the interior meets, in scan order; touching is not meeting. Exact.
// REQUIRES: a valid zone. Time O(rows * corners + cells).
std::vector<Cell> cells_in(const Zone& zone, int width, int height);

}  // namespace waybreaker::zones
