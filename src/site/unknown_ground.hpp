// Unknown ground: cells of which nobody knows what is there, beyond the source's data or unseen by a robot. On maps
// they are obstacles that cannot be destroyed, with a tag of their own.
#pragma once

#include <cstdint>
#include <vector>

#include "site/obstacle_tags.hpp"
#include "waybreaker/map.hpp"

namespace waybreaker::site {

inline constexpr const char* unknown_tag = "occupancy=unknown";

// By id, entry 0 unused: whether the obstacle is unknown ground.
std::vector<bool> unknown_obstacles(const Map& map, const ObstacleTags& tags);

// How many cells of the map are.
std::uint64_t unknown_cells(const Map& map, const ObstacleTags& tags);

}  // namespace waybreaker::site
