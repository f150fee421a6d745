// Missions of teams: several ground agents, and aircraft.
#pragma once

#include "coalition/coalition.hpp"
#include "waybreaker/planner.hpp"

namespace waybreaker {

// REQUIRES: the mission is a team's, and valid.
Plan plan_team(const Map& map, const Mission& mission, const Method& method, const Limits& limits,
               coalition::Fewer fewer, Searcher& searcher, CrossingSearcher& crossing);

}  // namespace waybreaker
