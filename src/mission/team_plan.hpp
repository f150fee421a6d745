// Missions of teams: several ground agents, and aircraft.
#pragma once

#include "coalition/coalition.hpp"
#include "mission/alternatives.hpp"
#include "waybreaker/planner.hpp"

namespace waybreaker {

// Who comes first decides who gives way: the same agents in another order may have another plan (agent_order.hpp).
// Appends to `evaluated` what is an alternative to the plan. REQUIRES: the mission is valid, and not one of a single
// ground agent with aircraft.
Plan plan_team(const Map& map, const Mission& mission, const Method& method, const Limits& limits,
               coalition::Fewer fewer, Searcher& searcher, CrossingSearcher& crossing, Evaluated* evaluated = nullptr);

}  // namespace waybreaker
