// Checks of a query.
#pragma once

#include "waybreaker/advanced/crossing.hpp"

namespace waybreaker {

// Throws InputError, naming what is wrong, if the options contradict each other or the map.
void validate(const Map& map, const CrossingOptions& options);

}  // namespace waybreaker
