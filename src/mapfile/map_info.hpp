// What a map file says of its place, beside its figures (io/map_info.hpp).
#pragma once

#include <array>
#include <nlohmann/json.hpp>
#include <string>

#include "io/map_file.hpp"

namespace waybreaker::mapfile {

// Longitude and latitude of the middle of the map. Precondition: it has a georeference.
std::array<double, 2> center(const io::MapFile& file);

// The coordinate system that the metres of the map's frame (io/map_frame.hpp) are coordinates of, such as "EPSG:32633";
// empty if they are of the map's own.
std::string frame_crs(const io::MapFile& file);

// The member "georeference" of `waybreaker map info --json`: null for a map without one.
nlohmann::ordered_json georeference_json(const io::MapFile& file);

// What `waybreaker map info --json` writes: an indented object.
std::string map_info_json(const io::MapFile& file);

}  // namespace waybreaker::mapfile
