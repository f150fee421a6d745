// Rubble: what is left of a removed obstacle, and how much longer a ground agent takes because of it (Rules::rubble).
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "waybreaker/body.hpp"
#include "waybreaker/map.hpp"
#include "waybreaker/plan.hpp"

namespace waybreaker {

struct Rubble {
    std::span<const ObstacleId> obstacles = {};  // that are removed, each once
    double time = 0;                             // for each; 0: there is none
};

// How many of those obstacles a path first touches on the move from each of its points to the next one; not what the
// agent is in from the start.
std::vector<std::size_t> rubble_on(const Map& map, std::span<const Waypoint> path, const Body& body,
                                   std::span<const ObstacleId> obstacles);

// The path driven from that time on, with stops only for rubble, each at the turn before it: a point twice.
std::vector<Waypoint> timed_through(const Map& map, std::span<const Point> path, const Body& body, double speed,
                                    double from, const Rubble& rubble);

}  // namespace waybreaker
