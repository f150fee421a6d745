// How many bytes of memory a map takes once it is read.
#pragma once

#include "io/map_file.hpp"

namespace waybreaker::io {

std::size_t memory_of(const MapFile& file);

}  // namespace waybreaker::io
