// How far aircraft may fly: what they cannot breach and come home from.
#pragma once

#include <optional>
#include <string>

#include "waybreaker/map.hpp"
#include "waybreaker/mission.hpp"
#include "waybreaker/plan.hpp"

namespace waybreaker {

// "the air1 agent can fly 900 cells; obstacle 473 and back is 1100": or in units of time, where these end first. `what`
// takes `time`.
std::string flight_sentence(const Agent& agent, const std::string& what, double time);

// Throws InputError, with the figures, if an agent's range, endurance, reserve or time in the air is out of range or
// not an aircraft's, it may not fly from its start to its goal, or something must be removed that none can fly to and
// home. REQUIRES: a mission that is valid but for these.
void validate_flights(const Map& map, const Mission& mission);

// Why no aircraft that may breach breaches that obstacle and comes home, of the one that comes nearest to it; empty if
// one can. REQUIRES: aircraft have their airspace.
std::optional<OutOfRange> out_of_range(const Map& map, const Mission& mission, ObstacleId id);

// The mission with all that protected which no aircraft can breach and come home from. REQUIRES: as above.
Mission protecting_out_of_range(const Map& map, const Mission& mission);

}  // namespace waybreaker
