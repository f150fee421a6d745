// Where a vehicle stands to breach an obstacle.
#pragma once

#include <optional>

#include "waybreaker/map.hpp"
#include "waybreaker/mission.hpp"

namespace waybreaker::clearing {

// The cell from which a vehicle at `from` breaches the obstacle, its disc at most so far away: so that its drive there,
// from cell to neighbouring cell, and the straight line on to `next` are shortest together, or its drive there alone,
// without a next place. Empty where it gets to none. REQUIRES: the obstacle stands on the map; the vehicle fits at
// `from`.
std::optional<Cell> standing_place(const OpenedMap& map, const Agent& vehicle, Cell from, ObstacleId obstacle,
                                   std::optional<Point> next);

}  // namespace waybreaker::clearing
