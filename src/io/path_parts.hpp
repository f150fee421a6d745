// A path in parts, for robots that follow places and ignore times: each part is driven in one go, and may begin only
// when what it waits for has happened.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "waybreaker/plan.hpp"

namespace waybreaker::io {

struct PathPart {
    // Points of the path. The next part begins where this one ends.
    std::size_t first = 0;
    std::size_t last = 0;
    std::vector<ObstacleId> openings = {};  // that it is the first part to touch, by id: they must be open by then
};

// A path is cut where its agent waits, and at the last bend before a removed obstacle that it has not touched yet,
// whether it waits there or not. Parts that lead nowhere are left out: who never moves has none. `radius` counts
// thousandths of a cell; 0 is a point. Precondition: the plan is one for this map, and the agent one of its own.
std::vector<PathPart> path_parts(const Map& map, const Plan& plan, const Itinerary& agent, std::int64_t radius);

}  // namespace waybreaker::io
