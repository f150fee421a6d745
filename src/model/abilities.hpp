// Abilities: which obstacles each agent may breach, and how long it takes.
#pragma once

#include <span>

#include "waybreaker/map.hpp"
#include "waybreaker/mission.hpp"
#include "waybreaker/plan.hpp"

namespace waybreaker {

// Throws InputError if an agent's time to breach, reach or choice of obstacles is out of range or names what is not
// there, or something must be removed that no agent may breach. REQUIRES: a mission that is valid but for these.
void validate_abilities(const Map& map, const Mission& mission);

// The first obstacle that must be removed and that no agent may breach; none in most missions.
ObstacleId forced_but_unbreachable(const Map& map, const Mission& mission);

// The mission with all that protected which no agent may breach.
Mission protecting_unbreachable(const Map& map, const Mission& mission);

// Says of breaches that name nobody, as those of an only aircraft do, that it is the mission's first one, and when each
// began.
void name_breacher(const Map& map, const Mission& mission, std::span<Breach> breaches);

}  // namespace waybreaker
