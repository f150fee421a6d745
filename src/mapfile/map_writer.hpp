// Writes maps in all supported formats, and reports what the format cannot hold.
#pragma once

#include <string>
#include <vector>

#include "io/map_file.hpp"
#include "io/output_file.hpp"

namespace waybreaker::mapfile {

struct WrittenMap {
    std::vector<io::OutputFile> files;  // one; of a ROS map the image first, then the YAML that names it
    std::vector<std::string> losses;    // what the format does not hold of this map, a line each
};

// Whether the format that the extension of `path` stands for says which cell belongs to which obstacle. Throws as
// below.
bool holds_obstacles(const std::string& path);

// The map in the format that the extension of `path` stands for: .map (MovingAI), .xml (the authors'), .tif (labels),
// .geojson, .yaml (ROS, with a PGM of the same name beside it), .png, .pgm. A ROS map becomes a ROS map to the byte,
// but for the image's name. Throws InputError, naming the extensions there are.
WrittenMap write_map(const io::MapFile& map, const std::string& path);

}  // namespace waybreaker::mapfile
