// Maps with other obstacles than their file has: some gone, some new.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "io/map_file.hpp"

namespace waybreaker::mapfile {

// Gives the map other labels. What was the id of an obstacle is still that obstacle, with its name and all that is
// known of it; numbers above all ids are new obstacles, and 0 is free.
void relabel(io::MapFile& file, std::vector<std::uint32_t> labels);

// The map after the removal of these obstacles. Of a ROS map the image changes too: what was unknown stays unknown, and
// no cell but theirs becomes free. Throws InputError if there is no such obstacle, or it cannot be destroyed.
io::MapFile without_obstacles(const io::MapFile& file, std::span<const ObstacleId> removed);

}  // namespace waybreaker::mapfile
