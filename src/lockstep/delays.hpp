// Routes for vehicles that are too wide to turn into where another leaves.
#pragma once

#include <vector>

#include "lockstep/configurations.hpp"
#include "lockstep/occupancy.hpp"

namespace waybreaker::lockstep {

// The same moves, each vehicle's and each site's in the same order, but later where that is needed for nobody to turn
// into where another leaves in the same step. Ends, as nobody goes round in a circle: somebody can always move on.
std::vector<Route> delayed_at_turns(const std::vector<Configuration>& configurations);

// It stands at the last site for ever, anyway.
void leave_out_rest(Route& route);

}  // namespace waybreaker::lockstep
