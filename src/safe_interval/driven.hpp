// A known way driven as early as can be, nobody else being there.
#pragma once

#include <span>
#include <vector>

#include "waybreaker/advanced/safe_interval.hpp"

namespace waybreaker::safe_interval {

// How early a straight move that lasts so long may begin: when every obstacle that it touches is gone by then, and
// has been for as long as its rubble takes.
double opened_for(const Map& map, Cell from, Cell to, double duration, const SafeIntervalOptions& options);
// How long the agent stands before a straight move for the rubble of what it touches on it, but not before.
double rubble_before(const OpenedMap& map, Cell from, Cell to, const SafeIntervalOptions& options);

// Along the way, once the agent is ready; with stops only for rubble and for what opens late, each at the last turn
// before it. REQUIRES: the way is not empty.
std::vector<Waypoint> driven(const OpenedMap& map, std::span<const Cell> way, const SafeIntervalOptions& options);

}  // namespace waybreaker::safe_interval
