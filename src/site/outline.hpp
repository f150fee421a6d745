// The outlines of obstacles as polygons, for formats that hold no cells.
#pragma once

#include <span>
#include <vector>

#include "waybreaker/map.hpp"

namespace waybreaker::site {

// Closed: the last point is the first. In cell units, along the sides of cells, so at halves.
using Ring = std::vector<Point>;
// The outer ring, then those of holes.
using Polygon = std::vector<Ring>;

// The polygons of each obstacle, outlines[id], entry 0 unused: one for every 4-connected part of it.
std::vector<std::vector<Polygon>> outlines(const Map& map);

// The same for one obstacle; time and memory O(its bounding box). REQUIRES: the map has that obstacle.
std::vector<Polygon> outline(const Map& map, ObstacleId id);

}  // namespace waybreaker::site
