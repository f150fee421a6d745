// Flights that end before the battery does.
#pragma once

#include <functional>

#include "mission/alternatives.hpp"
#include "waybreaker/limits.hpp"
#include "waybreaker/map.hpp"
#include "waybreaker/method.hpp"
#include "waybreaker/mission.hpp"
#include "waybreaker/plan.hpp"

namespace waybreaker {

using MissionPlanner = std::function<Plan(const Mission&, const Method&, const Limits&)>;

// First as if aircraft could fly any distance: a plan that keeps to their ranges all the same is the plan. Else what no
// aircraft can breach and come home from is protected, and the mission planned with the ranges. Where some recharge, it
// is the better of that and of the plan in which nobody does. Where nobody has a range, as `planned` does. `evaluated`
// may be null.
Plan within_range(const Map& map, const Mission& mission, const Method& method, const Limits& limits,
                  const MissionPlanner& planned, Evaluated* evaluated);

}  // namespace waybreaker
