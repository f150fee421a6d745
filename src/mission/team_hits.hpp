// The paper's way to select, for several vehicles: an obstacle's hits are those of all vehicles' searches together.
#pragma once

#include <cstdint>
#include <vector>

#include "team/vehicle.hpp"
#include "waybreaker/map.hpp"
#include "waybreaker/method.hpp"
#include "waybreaker/mission.hpp"

namespace waybreaker {

// How often the vehicles ran into each obstacle, by id: each searches its path alone, nothing removed, by the method's
// planner (Theta* in place of the optimal one).
std::vector<std::uint32_t> hits_of_team(const Map& map, const Mission& mission, const Method& method,
                                        const team::Interrupts& interrupts, Searcher& searcher);

}  // namespace waybreaker
