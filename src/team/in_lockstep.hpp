// A first plan for a team whose vehicles crowd each other: they move in lockstep (lockstep/lockstep.hpp).
#pragma once

#include <span>

#include "team/fleet.hpp"
#include "team/vehicle.hpp"

namespace waybreaker::team {

// Gives every vehicle a path; changes nothing, and says false, if none is found: that is for vehicles of one body and
// one speed that are ready at the same time, on ground where nothing opens later.
bool move_in_lockstep(const Ground& ground, std::span<const Vehicle> vehicles, const Rules& rules,
                      const Interrupts& interrupts, Fleet& fleet);

}  // namespace waybreaker::team
