// Maps whose obstacles differ from those of their file: some removed, some new.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "io/map_file.hpp"

namespace waybreaker::mapfile {

// Replaces the labels of the map. Existing ids still stand for the same obstacles, with their names and attributes;
// higher numbers are new obstacles, and 0 is free.
void relabel(io::MapFile& file, std::vector<std::uint32_t> labels);

// The map after the removal of these obstacles. Of a ROS map the image changes too: what was unknown stays unknown, and
// no cell but theirs becomes free. Throws InputError if there is no such obstacle, or it cannot be destroyed.
io::MapFile without_obstacles(const io::MapFile& file, std::span<const ObstacleId> removed);

}  // namespace waybreaker::mapfile
