// Reach of a mission with many places: how soon its vehicles get to any cell, places or not.
#pragma once

#include <optional>

#include "model/reach.hpp"
#include "waybreaker/plan.hpp"

namespace waybreaker {

// Of a solved plan whose ground agents do not collide, are alike, and have fewer starts than goals (then starts are the
// hubs) or fewer goals than starts; empty for all others, and for maps and numbers of hubs that would take long.
//
// Theta*'s ways, with a stop where they are not open yet: no shorter way to wait is looked for, as the planner does for
// its vehicles. Of up to four openings that are not there from the beginning, each cell has the best of all sets of
// them, else of sets of those that are there first.
std::optional<Reach> reach_of(const Map& given, const Mission& asked, const Plan& plan);

}  // namespace waybreaker
