// States: whether one can be of a plan, and the map as it is known then.
#pragma once

#include <span>
#include <vector>

#include "waybreaker/map.hpp"
#include "waybreaker/mission.hpp"
#include "waybreaker/plan.hpp"
#include "waybreaker/state.hpp"

namespace waybreaker::live {

// Throws InputError, naming what is wrong.
void validate(const Map& map, const Mission& mission, const Plan& plan, const State& state);

// What was found, and the cells of agents that have stopped on the ground, which block the way. `stopped`: where.
struct Stopped {
    Point at;
    Body body;
};
std::vector<Found> found_by(const Map& map, const State& state, std::span<const Stopped> stopped);

}  // namespace waybreaker::live
