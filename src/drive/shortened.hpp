// Shortened: what a disc can do better than the square around it.
#pragma once

#include <vector>

#include "waybreaker/body.hpp"

namespace waybreaker {

// The cell at whose centre a point lies.
Cell cell_of(Point p);

// A path that the disc drives as well, no longer: bends that it does not need are gone, others lie up to three cells
// nearer. The path bends at cell centres and is legal on the map.
std::vector<Point> shortened(const OpenedMap& map, const Body& body, std::vector<Point> path);

}  // namespace waybreaker
