// Of the plans of a team that are about as good as the best one, the one that demolishes the least.
#pragma once

#include <functional>

#include "core/stopwatch.hpp"
#include "waybreaker/map.hpp"
#include "waybreaker/mission.hpp"
#include "waybreaker/plan.hpp"

namespace waybreaker {

// Plans a team on a map under a mission, in so many seconds.
using TeamPlanner = std::function<Plan(const Map&, const Mission&, double)>;

// `best`: the plan of the mission where nothing is minimised. The result has its bound.
// REQUIRES: rules.minimise_demolition, and weights in proportion to cells if there is a budget.
Plan demolish_least_as_team(const Map& map, const Mission& mission, const Deadline& deadline,
                            const TeamPlanner& planned, const Plan& best);

}  // namespace waybreaker
