// Reads any supported map file; the format is detected by content.
#pragma once

#include <string>

#include "io/map_file.hpp"
#include "map/map_size.hpp"

namespace waybreaker::mapfile {

// Throws InputError. A file that is not a map is refused after its first bytes; "-" is standard input. `connectivity`
// applies to formats without a label layer.
io::MapFile read_map_file(const std::string& path, Connectivity connectivity = Connectivity::four,
                          const io::ImageReading& image = {});

// The bytes of such a file.
std::string read_map_bytes(const std::string& path);

// Parses a map from bytes alone: no other file is opened, so a ROS map must be in one piece
// (ros_pieces). `name` is what errors call it. Throws SizeError for a map of too many cells, before it allocates memory
// for them.
io::MapFile parse_map(std::string bytes, const std::string& name, Connectivity connectivity = Connectivity::four,
                      const io::ImageReading& image = {}, const MapLimits& limits = {});

}  // namespace waybreaker::mapfile
