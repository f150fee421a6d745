// Fitted: a path of the disc along the path of a point.
#pragma once

#include <span>
#include <vector>

#include "waybreaker/body.hpp"
#include "waybreaker/map.hpp"

namespace waybreaker {

// The shortest path of a disc from cell to cell, of those that bend at centres of cells near to a path that a point
// drives between the same cells (`guide`). The point may slip through where the disc does not: then, or where nothing
// is shorter than `shorter_than` cells, none is found, and the path is empty. `thorough`: with bends farther from those
// of the guide, if need be.
std::vector<Point> fitted(const OpenedMap& map, const Body& body, std::span<const Point> guide, double shorter_than,
                          bool thorough);

}  // namespace waybreaker
