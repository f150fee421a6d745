// Places: which maps show one place and so are alike. Intervals take places, not maps, for independent.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "experiment/experiment.hpp"

namespace waybreaker::experiment {

struct Places {
    std::vector<std::size_t> of_map;  // by map
    std::size_t count = 0;
};

// A pattern of Experiment::places is a place, which holds the maps whose names it fits; every other map is a place of
// its own. Throws InputError for a pattern that fits no map, and for a map that two fit; `spec` is what errors name.
Places places_of(const Experiment& experiment, const std::string& spec);

}  // namespace waybreaker::experiment
