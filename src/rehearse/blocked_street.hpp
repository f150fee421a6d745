// Blocked streets: what a vehicle sees on its way.
#pragma once

#include <span>

#include "rehearse/actor.hpp"
#include "waybreaker/map.hpp"
#include "waybreaker/plan.hpp"

namespace waybreaker::rehearsal {

// The free cells around the place so far ahead of a vehicle on its path. None where the path ends before; no street is
// blocked where a vehicle is or is to end.
Found blocked_street(const Map& map, const Actor& finder, std::span<const Actor> actors, double sight, double now);

}  // namespace waybreaker::rehearsal
