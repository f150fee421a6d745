// Crews: vehicles that clear the way for others, beside aircraft or without. What they breach and in which order is
// searched for; given that, they drive at once, and the others are planned as past obstacles that open by themselves.
//
// The bound is that of a relaxed mission: each vehicle that clears drives as one that does not, and an aircraft of its
// speed breaches for it. A drive is no shorter than a flight, except that a vehicle stands beside what it breaches and
// an aircraft at a cell of its boundary; that is allowed for.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "crew/clearing.hpp"
#include "waybreaker/limits.hpp"
#include "waybreaker/plan.hpp"

namespace waybreaker::crew {

// Plans missions in which no vehicle clears for others. With a share, the first is the plan, and the others are what
// was found beside it that is worse by no more than that.
using Planned =
    std::function<std::vector<Plan>(const Mission&, const Method&, const Limits&, std::optional<double> share)>;

struct CrewPlan {
    Plan plan;        // of the mission, but for waits, orders and when what is breached is entered
    Mission mission;  // the one that the vehicles' paths were planned for, as Planned saw it
};

// REQUIRES: a valid mission with vehicles that clear (Mission::clears), without zones. Not explained.
CrewPlan plan_crew(const Map& map, const Mission& mission, const Method& method, const Limits& limits,
                   const Searchers& searchers, const Planned& planned);

}  // namespace waybreaker::crew
