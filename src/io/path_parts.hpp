// A path in parts, for robots that follow places and ignore times: each part is driven in one go, and may begin only
// when what it waits for has happened.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "waybreaker/mission.hpp"
#include "waybreaker/plan.hpp"

namespace waybreaker::io {

struct PathPart {
    // Points of the path. The next part begins where this one ends.
    std::size_t first = 0;
    std::size_t last = 0;
    std::vector<ObstacleId> openings = {};  // that it is the first part to touch, by id: they must be open by then
};

// A path is cut where its agent waits, where the base of a revision ends (decision_point), and at the last bend before
// an obstacle of openings_of that it has not touched yet, whether it waits there or not. Parts that lead nowhere are
// left out: who never moves has none. REQUIRES: the plan is one of this mission on this map; `agent` counts its agents.
std::vector<PathPart> path_parts(const Map& map, const Mission& mission, const Plan& plan, std::size_t agent);

// What opens while the plan is carried out, by id: what is breached, and what opens at a later time that the mission
// states, such as a breach that had begun when the plan was revised.
std::vector<ObstacleId> openings_of(const Mission& mission, const Plan& plan);

// The point of its path at which the agent's base ends, in a plan that revises another.
std::optional<std::size_t> decision_point(const Plan& plan, std::string_view agent);

}  // namespace waybreaker::io
