// Timeline: who is where when, and when the ground agent first touches a removed obstacle.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "waybreaker/map.hpp"
#include "waybreaker/plan.hpp"

namespace waybreaker {

// Length of a path, in cells.
double path_length(std::span<const Point> path);

// The path driven without a stop from that time on.
std::vector<Waypoint> timed(std::span<const Point> path, double speed, double from = 0);

// The path without its times and waits.
std::vector<Point> places(std::span<const Waypoint> path);

// Where an agent stands on its path, and for how long; without reasons.
std::vector<Wait> stands(const Itinerary& agent);

// Where on its path an agent first touches something, and when.
struct Touch {
    std::size_t move = 0;  // from that point of the path to the next one
    double share = 0;      // of the move, 0 to 1
    double time = 0;
};

// Where that is. REQUIRES: a touch on the path, in time.
Point place_of(std::span<const Point> path, const Touch& touch);

// When an agent of that radius (cells; 0 for a point) first touches a cell of the obstacle: the first time after which
// its open disc meets the closed cell, a point the open cell; a point that moves along a side between two blocked cells
// touches both. Empty if it never does.
std::optional<Touch> first_touch_on(const Map& map, ObstacleId obstacle, std::span<const Waypoint> path, double radius);
std::optional<double> first_touch(const Map& map, ObstacleId obstacle, std::span<const Waypoint> path, double radius);

// The radius of what must be clear of an obstacle that stands. A point touches nothing when it passes between two
// diagonal neighbours; one that may not do so has a hair's breadth.
double standing_radius(const Body& body);

}  // namespace waybreaker
