// Maps whose obstacles differ from those of their file: some removed, some new, cut into sections, or under a flood.
#pragma once

#include <span>

#include "io/map_file.hpp"
#include "site/overlay.hpp"
#include "site/sections.hpp"

namespace waybreaker::mapfile {

// The map after the removal of these obstacles. Of a ROS map the image changes too: what was unknown stays unknown, and
// no cell but theirs becomes free. Throws InputError if there is no such obstacle, or it cannot be destroyed.
io::MapFile without_obstacles(const io::MapFile& file, std::span<const ObstacleId> removed);

// The map with what can be destroyed cut into sections: see site/split.hpp. Throws InputError if it has sections
// already.
io::MapFile in_sections(io::MapFile file, const site::Lattice& lattice);

// The map with an overlay of its size laid over it: see site/overlay.hpp.
io::MapFile with_overlay(io::MapFile file, const site::Overlay& overlay);

}  // namespace waybreaker::mapfile
