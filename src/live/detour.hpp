// Detour: how an aircraft that is off its planned path keeps out of zones on its way back to it.
#pragma once

#include "live/position.hpp"
#include "waybreaker/map.hpp"
#include "waybreaker/mission.hpp"

namespace waybreaker::live {

// Adds the detour to its position, and puts off what is ahead by as much. One that is found in a zone flies straight to
// the nearest cell centre outside from which there is a way on.
void fly_round_zones(const Map& map, const Agent& aircraft, Position& position);

}  // namespace waybreaker::live
