// The ground painted on cells: what blocks for ever, and where ways open what stands on it.
//
// A cell is what its centre is covered by, a later one wins: sides of bridges, water, ways over both, forbidden ground,
// (buildings, barriers,) ways. Ways open each cell that their line touches, and those around it that the vehicle needs,
// so that its disc can follow them. What blocks for ever does so under buildings and barriers as well: who destroys a
// house over a river finds the river.
#pragma once

#include <cstdint>
#include <vector>

#include "city/ground.hpp"
#include "city/import_window.hpp"
#include "site/cell_run.hpp"

namespace waybreaker::city {

struct GroundMap {
    // For each cell the number, from 1, of the piece that blocks it for ever, 0 for none.
    std::vector<std::uint32_t> blocked;
    // What ways open for each cell; no entries if there are no ways.
    enum Opens : std::uint32_t { nothing, barriers, forbidden_lines, everything };
    std::vector<std::uint32_t> opened;
    // Where ways lead, as wide as they are, and where a bridge leads; row by row, whatever blocks there.
    std::vector<site::CellRun> ways;
    std::vector<site::CellRun> bridges;
    // The ways once more, other than 0 where one leads, for a profile that keeps to roads; no entries for others.
    std::vector<std::uint32_t> roads;
};

// `cell`: its side in metres.
GroundMap ground_map(const std::vector<GroundPiece>& pieces, const CellWindow& window, Profile profile, double cell);

}  // namespace waybreaker::city
