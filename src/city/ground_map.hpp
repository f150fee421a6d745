// The ground painted on cells: what blocks for ever, and where ways open what stands on it.
//
// A cell is what its centre is covered by, a later one wins: water, ways over it, forbidden ground, (buildings,
// barriers,) ways. Ways open each cell that they touch, so that a disc that fits into a cell can follow them. What
// blocks for ever does so under buildings and barriers as well: who destroys a house over a river finds the river.
#pragma once

#include <cstdint>
#include <vector>

#include "city/ground.hpp"
#include "city/import_window.hpp"

namespace waybreaker::city {

struct GroundMap {
    // For each cell the number, from 1, of the piece that blocks it for ever, 0 for none.
    std::vector<std::uint32_t> blocked;
    // What ways open for each cell; no entries if there are no ways.
    enum Opens : std::uint32_t { nothing, barriers, forbidden_lines, everything };
    std::vector<std::uint32_t> opened;
    // Other than 0 where a bridge leads; no entries if there are none.
    std::vector<std::uint32_t> bridges;
};

GroundMap ground_map(const std::vector<GroundPiece>& pieces, const CellWindow& window);

}  // namespace waybreaker::city
