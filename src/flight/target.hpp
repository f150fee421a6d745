// Target: an obstacle to breach and the cells it can be breached from; and a tour of targets, as the flight rules pass
// it among themselves.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "waybreaker/advanced/flight.hpp"

namespace waybreaker {

struct Target {
    ObstacleId obstacle;
    std::vector<Cell> cells;  // of its boundary, in scan order; never empty
};

// The obstacles' targets in id order, each once, with the cells that an air agent gets to from `start`. Throws
// InputError for an obstacle without any.
std::vector<Target> targets_of(const Map& map, std::span<const ObstacleId> obstacles, const Airspace& air = {},
                               Point start = {});

// A visit of targets[target] at one of its cells; or a landing at a base, to recharge.
struct Stop {
    static constexpr std::size_t base = std::size_t(-1);
    std::size_t target = 0;
    Cell at;

    bool lands() const { return target == base; }
};
using Tour = std::vector<Stop>;

// A gain below this, in cells, is rounding: without it a search could turn in circles.
inline constexpr double least_gain = 1e-9;

double tour_length(Point start, const Tour& tour, Point goal, const Airspace& air = {});

Flight flight_of(Point start, const Tour& tour, Point goal, std::span<const Target> targets, const Airspace& air = {});

// The paper's rule for n > 1 (see fly_nearest), one stop for each target.
Tour nearest_tour(Point start, Point goal, std::span<const Target> targets);

}  // namespace waybreaker
