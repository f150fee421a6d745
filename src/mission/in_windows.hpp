// Zones that hold for a time: plans that keep out of them while they do.
#pragma once

#include <functional>
#include <vector>

#include "waybreaker/limits.hpp"
#include "waybreaker/map.hpp"
#include "waybreaker/method.hpp"
#include "waybreaker/mission.hpp"
#include "waybreaker/plan.hpp"

namespace waybreaker {

// The plan of a valid mission whose zones hold all the time, and alternatives to it.
using ZonedPlanner = std::function<std::vector<Plan>(const Mission&, const Method&, const Limits&)>;

// Whether a zone of the mission has a window.
bool has_windows(const Mission& mission);

// First as if there were no zones with a window: what is proven of that mission is proven. Where its plan is in such a
// zone while it holds, other missions take its place, of which the best goes on: in one the zone holds all the time, in
// one the agent sets out so much later that the zone is over when it comes there, in others an aircraft flies in from
// where that is best. The best plan that keeps out of all zones is the plan, or the best that removes nothing, if that
// is better; it is `not_found` where none does, and Plan::barred_by names the zone. The bound of a makespan knows
// no-fly zones: who keeps out of one is bound by the mission in which it holds all the time, who does not flies in when
// it is over; an only breacher takes the time of a breach, unless nothing is removed. REQUIRES: a valid mission that
// has windows.
std::vector<Plan> in_windows(const Map& map, const Mission& mission, const Method& method, const Limits& limits,
                             const ZonedPlanner& planned);

}  // namespace waybreaker
