// A map with other labels.
#pragma once

#include <cstdint>
#include <vector>

#include "io/map_file.hpp"

namespace waybreaker::io {

// Replaces the labels of the map. Existing ids still stand for the same obstacles, with their names and attributes;
// higher numbers are new obstacles, and 0 is free.
void relabel(MapFile& file, std::vector<std::uint32_t> labels);

}  // namespace waybreaker::io
