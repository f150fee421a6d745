// Unknown space of ROS maps on label maps: obstacles with a tag of their own.
#pragma once

#include <vector>

#include "io/map_file.hpp"

namespace waybreaker::mapfile {

inline constexpr const char* unknown_tag = "occupancy=unknown";

// By id, entry 0 unused: whether the obstacle is unknown space.
std::vector<bool> unknown_obstacles(const io::MapFile& file);

// The map's annotations, those of a ROS map with the tag above.
site::Annotations annotations_with_unknown(const io::MapFile& file);

// How many cells those with the tag have.
std::uint64_t tagged_unknown_cells(const io::MapFile& file);

}  // namespace waybreaker::mapfile
