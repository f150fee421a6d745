// Cells of a window as runs, row by row.
#pragma once

#include <cstdint>
#include <vector>

#include "city/import_window.hpp"
#include "site/cell_run.hpp"
#include "waybreaker/map.hpp"

namespace waybreaker::city {

// The cells whose label is not 0; labels row by row.
std::vector<site::CellRun> runs_of(const std::vector<std::uint32_t>& labels, const CellWindow& window);

// The parts of runs that are free on the map.
std::vector<site::CellRun> open_parts(const std::vector<site::CellRun>& runs, const Map& map);

}  // namespace waybreaker::city
