// Vehicles that clear the way for others, beside aircraft or without. What they breach and in which order is searched
// for; given that, they drive at once, and the others are planned past obstacles that open by themselves. The bound is
// that of a relaxed mission (relaxed_mission.hpp).
#pragma once

#include <functional>
#include <vector>

#include "clearing/clearing_drive.hpp"
#include "waybreaker/limits.hpp"
#include "waybreaker/plan.hpp"

namespace waybreaker::clearing {

// How a mission in which no vehicle clears for others is planned: once; once more without each obstacle that opens
// late; or with what was found beside the plan that is about as good, after it.
enum class Care { once, around_late, with_others };
using Planned = std::function<std::vector<Plan>(const Mission&, const Method&, const Limits&, Care)>;

struct ClearingPlan {
    Plan plan;        // of the mission, but for waits, orders and when what is breached is entered
    Mission mission;  // the one that the vehicles' paths were planned for, as Planned saw it
};

// REQUIRES: a valid mission with vehicles that clear (Mission::clears), without zones. Not explained.
ClearingPlan plan_clearing(const Map& map, const Mission& mission, const Method& method, const Limits& limits,
                           const Searchers& searchers, const Planned& planned);

}  // namespace waybreaker::clearing
