// Battery: what an aircraft under way has used of it, and whether the rest brings it home.
#pragma once

#include "live/position.hpp"
#include "waybreaker/mission.hpp"
#include "waybreaker/plan.hpp"
#include "waybreaker/state.hpp"

namespace waybreaker::live {

// Sets Agent::flown of `agent`, which is `was` at the end of its base; no more than that, where its battery has no end.
// Where only the reserve brings it home, it keeps the less of it. Throws InputError, naming it, where nothing does.
// `said`: what is reported of it, or null; `now`: when that was.
void use_battery(const Agent& was, const Itinerary& planned, const Position& position, const AgentState* said,
                 double now, Agent& agent);

}  // namespace waybreaker::live
