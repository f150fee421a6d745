// Who waits for whom and where, found from a finished plan alone.
#pragma once

#include "waybreaker/map.hpp"
#include "waybreaker/mission.hpp"
#include "waybreaker/plan.hpp"

namespace waybreaker {

// Fills in the waits of all ground agents. Exact: by the departures at which each move to the next stop would come too
// near to another disc or touch an obstacle that stands; waits shorter than a millionth are rounding. Time O(waits *
// agents) plus O(points of the run * points of the path) for each that comes near. REQUIRES: the plan is solved, and
// its agents are the mission's.
void add_waits(const Map& map, const Mission& mission, Plan& plan);

}  // namespace waybreaker
