// What obstacles weigh, by a text file, one "ID WEIGHT" a line ("#" begins a comment), by their cells, or by
// their area.
#pragma once

#include <string>
#include <vector>

#include "io/map_file.hpp"
#include "waybreaker/map.hpp"

namespace waybreaker::io {

// weights[id] of every obstacle of the map, entry 0 unused; those the file does not name weigh 1. Throws InputError,
// naming file and line, on anything else, on ids the map does not have or that come twice, and on weights that are not
// positive numbers.
std::vector<double> read_weights(const std::string& path, const Map& map);

// The same, of each its number of cells.
std::vector<double> cell_weights(const Map& map);

// The same, of each its area in square metres. Throws InputError if the map does not say how large a cell is.
std::vector<double> area_weights(const MapFile& map);
// With cells of that side, in metres.
std::vector<double> area_weights(const Map& map, double cell_size);

}  // namespace waybreaker::io
