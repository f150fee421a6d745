// The best cells of all stops at once, for a given order of the stops.
#pragma once

#include <span>

#include "flight/target.hpp"

namespace waybreaker {

// Makes the tour the shortest one that visits its targets in its order, by dynamic programming over their cells.
// Whether it got shorter. Leaves the tour alone if its neighbouring stops have more than a million pairs of cells to
// choose from.
bool choose_best_cells(Point start, Tour& tour, Point goal, std::span<const Target> targets, const Airspace& air = {});

}  // namespace waybreaker
