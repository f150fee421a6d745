// What obstacles weigh, as a text file: one "ID WEIGHT" a line; "#" begins a comment.
#pragma once

#include <string>
#include <vector>

#include "waybreaker/map.hpp"

namespace waybreaker::io {

// weights[id] of every obstacle of the map, entry 0 unused; those the file does not name weigh 1. Throws InputError,
// naming file and line, on anything else, on ids the map does not have or that come twice, and on weights that are not
// positive numbers.
std::vector<double> read_weights(const std::string& path, const Map& map);

}  // namespace waybreaker::io
