// Flight: the air agent's way from start to goal that breaches every chosen obstacle.
//
// An obstacle is breached by visiting a cell of its boundary (Map::boundary). The air agent flies straight, over
// anything but the zones of its airspace, round which it takes the shortest way; it breaches from no cell in a zone.
// Preconditions of all functions: the ids name obstacles of the map; the airspace leaves a way from start to goal.
#pragma once

#include <span>
#include <vector>

#include "waybreaker/airspace.hpp"
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
// nearer to start, then scan order), visited in order of distance from start. An obstacle that fills the whole map, or
// has no cell beside it that the airspace leaves a way to, cannot be breached: throws InputError.
Flight fly_nearest(const Map& map, Point start, Point goal, std::span<const ObstacleId> obstacles,
                   const Airspace& air = {});

// The shortest flight over all orders and boundary cells: proven for up to `exact_flight_limit` obstacles (for one it
// is the paper's rule for n = 1), beyond that a good flight that is never longer than fly_nearest's.
inline constexpr std::size_t exact_flight_limit = 8;
Flight fly_optimal(const Map& map, Point start, Point goal, std::span<const ObstacleId> obstacles,
                   const Airspace& air = {});

}  // namespace waybreaker
