// Prepares lines for drawing: joins ways to streets, clips them to a window.
#pragma once

#include <ogr_core.h>

#include <vector>

#include "waybreaker/cell.hpp"

namespace waybreaker::city {

using Line = std::vector<Point>;

double length_of(const Line& line);

// Joins lines of two points or more end to end where they have an end in common. Same lines in the same order, same
// result.
std::vector<Line> joined(std::vector<Line> lines);

// The pieces of a line within bounds.
std::vector<Line> clipped(const Line& line, const OGREnvelope& bounds);

}  // namespace waybreaker::city
