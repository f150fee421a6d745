// Centres: what a path that bends at cell centres costs at least, by looking at all of them.
#pragma once

#include <cstdint>

#include "waybreaker/body.hpp"

namespace waybreaker {

// No path of the disc that bends at cell centres is shorter, in cells; never above `known`, the length of a path. That
// of the shortest one, unless it takes more than `most_looks` lines of sight, or an ellipse of too many cells: then a
// weaker limit, at worst the straight line. A* over cells whose neighbours are all cells in sight: O(c^2) looks for c
// cells in the ellipse. REQUIRES: a radius above 0, and start and goal on the map.
double least_through_centres(const OpenedMap& map, Cell start, Cell goal, const Body& body, double known,
                             std::uint64_t most_looks);

// A path so many times what is proven, or longer, is worth the look; lines of sight for one, a few milliseconds.
inline constexpr double worth_centres = 1.01;
inline constexpr std::uint64_t most_sight_lines = 100'000;

}  // namespace waybreaker
