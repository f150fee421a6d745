// The ground beside the roads, for a profile that keeps to them.
#pragma once

#include <vector>

#include "city/ground_map.hpp"
#include "site/described_map.hpp"

namespace waybreaker::city {

// Metres between a road and what can be removed beside it that a vehicle may cross: pavements and front gardens,
// without which a breach would seldom open a way. A choice.
inline constexpr double yard = 6;

// Makes obstacles of the free cells that are neither road nor yard: one, which cannot be destroyed. `cell`: its side in
// metres. Cells of buildings and barriers stay as they are, so that a vehicle crosses where these are removed.
void append_off_road(const GroundMap& ground, const CellWindow& window, double cell, site::LabelLayer& cells);

}  // namespace waybreaker::city
