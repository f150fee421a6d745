// The mission that bounds one with vehicles that clear: each vehicle that clears drives as one that does not, and an
// aircraft of its speed breaches for it.
#pragma once

#include <string>

#include "waybreaker/mission.hpp"

namespace waybreaker::clearing {

struct RelaxedMission {
    Mission mission;
    // A drive is no shorter than a flight, except that a vehicle stands beside what it breaches and an aircraft at a
    // cell of its boundary. By so much the objective may be below that of the relaxed mission.
    double allowance = 0;
};

RelaxedMission relaxed(const Mission& mission);

// The aircraft that breaches for a vehicle, by its id there.
std::string breacher_for(const Agent& vehicle);

}  // namespace waybreaker::clearing
