// Why an agent cannot start or end where it should, by what the map knows of that place.
#pragma once

#include <string>

#include "io/map_file.hpp"
#include "waybreaker/place_error.hpp"

namespace waybreaker::io {

bool is_in_unknown(const Misplaced& agent, const MapFile& map);

// "lies inside obstacle 2", or that it lies in unknown ground.
std::string place_reason(const Misplaced& agent, const MapFile& map);

}  // namespace waybreaker::io
