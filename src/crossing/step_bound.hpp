// Step bound: a lower bound of the length of paths, from steps from cell to cell. On dense maps, where the straight
// line says little and sets of obstacles are countless, it is known soon and near the truth: docs/exact.md, Theorem 5.
#pragma once

#include <cstdint>
#include <vector>

#include "waybreaker/advanced/crossing.hpp"

namespace waybreaker {

struct StepBound {
    double least = 0;                      // cells; no path is shorter, `length_limit` aside
    std::vector<ObstacleId> crossed = {};  // by the shortest path of steps; none if it was not found
    bool limited = false;                  // a limit ended the search
};

// For paths that bend at cell centres, of the unit square and of discs of radius 0.36 to 0.5, that cross what the
// options let them cross, weights and opening times aside. Time O(cells of the ellipse * (crossings + 1)), and as much
// for the boxes around obstacles; memory 8 bytes for each of them that is reached.
StepBound least_by_steps(const Map& map, Cell start, Cell goal, const CrossingOptions& options);

}  // namespace waybreaker
