// Any map file waybreaker reads, told apart by its content.
#pragma once

#include <string>

#include "io/map_file.hpp"
#include "map/map_size.hpp"

namespace waybreaker::mapfile {

// Throws InputError. A file that is no map is refused after its first bytes; "-" is standard input. `connectivity`
// applies to formats without a label layer.
io::MapFile read_map_file(const std::string& path, Connectivity connectivity = Connectivity::four,
                          const io::ImageReading& image = {});

// A map whose bytes are all there is of it: no other file is opened, so that a ROS map must be in one piece
// (ros_pieces). `name` is what errors call it. Throws SizeError for a map of too many cells, before it takes memory for
// them.
io::MapFile parse_map(std::string bytes, const std::string& name, Connectivity connectivity = Connectivity::four,
                      const io::ImageReading& image = {}, const MapLimits& limits = {});

}  // namespace waybreaker::mapfile
