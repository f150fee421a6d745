// Timed path: the best ground path for a set of obstacles that open in time. Who has to wait anyway waits where the
// rest of the way is shortest, which is seldom on the shortest path.
#pragma once

#include "select/candidate.hpp"

namespace waybreaker {

// A path of the crossing search as the ground agent can drive it: the shortest ways to its gates. No path if a limit
// comes first. `removed`: what is open in the end.
Opening drivable(const Task& task, const Searchers& searchers, const CrossingPath& path,
                 std::vector<ObstacleId> removed);

// Puts an opening in time. If the ground agent has to wait, other paths through the same obstacles are tried: each is
// the shortest for the breaches of the schedule before it, until none is better.
Candidate timed_candidate(const Task& task, const Searchers& searchers, Opening opening);

}  // namespace waybreaker
