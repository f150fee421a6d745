// Checks of a query.
#pragma once

#include "crossing/access.hpp"

namespace waybreaker {

// Throws InputError, naming what is wrong, if the options contradict each other or the map.
void validate(const Map& map, const CrossingOptions& options, const crossing::Opener& opener = {});

}  // namespace waybreaker
