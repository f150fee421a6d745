// Slow and obvious answers to compare the flight rules with, and random worlds to compare them on.
#pragma once

#include <rapidcheck.h>

#include <vector>

#include "waybreaker/advanced/flight.hpp"

namespace waybreaker {

// Boundary cells straight from their definition (contract, section 1).
std::vector<Cell> slow_boundary(const Map& map, ObstacleId id);

// The paper's rule for n > 1 in long doubles.
Flight slow_nearest(const Map& map, Cell start, Cell goal, std::vector<ObstacleId> ids);

// The least length over all orders and all boundary cells.
double slow_optimal_length(const Map& map, Cell start, Cell goal, std::vector<ObstacleId> ids);

// Every obstacle once, each at a cell of its boundary, and the length adds up.
void expect_valid(const Map& map, Cell start, Cell goal, const std::vector<ObstacleId>& ids, const Flight& flight);

// A whole number, first <= number < end, all equally likely from the first case on.
inline rc::Gen<int> uniform(int first, int end) {
    return rc::gen::resize(rc::kNominalSize, rc::gen::inRange(first, end));
}

struct World {
    Map map;
    Cell start;
    Cell goal;
    std::vector<ObstacleId> ids;
};

// A map of `obstacles` boxes of up to `side` cells a side (later ones may hide or split earlier ones), all of them to
// be breached, that leave at least one cell free.
rc::Gen<World> arbitrary_world(int width, int height, int obstacles, int side);

}  // namespace waybreaker
