// Obstacles that open late by themselves.
#pragma once

#include <functional>

#include "waybreaker/limits.hpp"
#include "waybreaker/map.hpp"
#include "waybreaker/mission.hpp"
#include "waybreaker/plan.hpp"

namespace waybreaker {

// The searches take what opens by itself as open: where that is late, it may be better to stay away from it. `planned`
// plans a mission in so many seconds.
Plan around_late(const Map& map, Mission mission, const Limits& limits,
                 const std::function<Plan(const Mission&, double)>& planned);

}  // namespace waybreaker
