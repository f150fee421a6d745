// Routes of live missions.
#pragma once

#include <vector>

#include "service/live_missions.hpp"
#include "service/map_store.hpp"
#include "service/route.hpp"

namespace waybreaker::service {

// The handlers keep the references.
std::vector<Route> mission_routes(LiveMissions& missions, MapStore& maps);

}  // namespace waybreaker::service
