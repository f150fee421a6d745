// Punctual: who comes to an obstacle before that is open gains by bending where it would have waited.
#pragma once

#include <cstdint>
#include <vector>

#include "waybreaker/map.hpp"
#include "waybreaker/plan.hpp"

namespace waybreaker {

struct PunctualPath {
    std::vector<Cell> path;
    std::uint64_t judged = 0;  // paths that were held against all openings: what it took
};

// Moves bends beside the place where an agent comes too early to the obstacle that delays it most, and adds one there,
// while it arrives earlier by that. The path bends at cell centres and is legal on the map, on which all are open.
// `rubble`: Rules::rubble.
PunctualPath punctual(const OpenedMap& map, const Agent& agent, std::vector<Cell> path,
                      std::vector<TimedOpening> openings, double rubble);

}  // namespace waybreaker
