// When what a plan removes is entered.
#pragma once

#include "waybreaker/map.hpp"
#include "waybreaker/mission.hpp"
#include "waybreaker/plan.hpp"

namespace waybreaker {

// Sets Breach::entered_at of all that is removed: when the first vehicle touches it.
void add_entries(const Map& map, const Mission& mission, Plan& plan);

}  // namespace waybreaker
