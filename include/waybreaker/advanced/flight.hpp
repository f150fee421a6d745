// Flight: the air agent's way from start to goal that breaches every chosen obstacle.
//
// An obstacle is breached by visiting a cell of its boundary (Map::boundary). The air agent flies straight, over
// anything. Precondition of all functions: the ids name obstacles of the map.
#pragma once

#include <span>
#include <vector>

#include "waybreaker/map.hpp"

namespace waybreaker {

struct BreachPoint {
    ObstacleId obstacle;
    Cell at;  // a cell of the obstacle's boundary
    friend bool operator==(const BreachPoint&, const BreachPoint&) = default;
};

struct Flight {
    std::vector<BreachPoint> breaches;  // in the order of the flight
    double length = 0;                  // start, every breach point, goal; in cells
};

// The paper's rule for n > 1: for each obstacle the boundary cell nearest to the segment start-goal (equally near: the
// nearer to start, then scan order), visited in order of distance from start. An obstacle that fills the whole map has
// no boundary and cannot be breached: throws InputError.
Flight fly_nearest(const Map& map, Point start, Point goal, std::span<const ObstacleId> obstacles);

// The shortest flight over all orders and boundary cells: proven for up to `exact_flight_limit` obstacles (for one it
// is the paper's rule for n = 1), beyond that a good flight that is never longer than fly_nearest's.
inline constexpr std::size_t exact_flight_limit = 8;
Flight fly_optimal(const Map& map, Point start, Point goal, std::span<const ObstacleId> obstacles);

}  // namespace waybreaker
