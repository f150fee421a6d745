// Rubble: what is left of a removed obstacle, and how much longer a ground agent takes because of it (Rules::rubble).
#pragma once

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

// Whether the body reaches into the obstacle there.
bool stands_in(const Map& map, ObstacleId obstacle, Point at, const Body& body);

// How long an agent stands at each point of a path: for the rubble of what it first touches on the move from there to
// the next one, unless it is in it from the start.
std::vector<double> stands_on(const Map& map, std::span<const Point> path, const Body& body, const Rubble& rubble);

// The path driven from that time on, with stops only for rubble, each at the turn before it: a point twice.
std::vector<Waypoint> timed_through(const Map& map, std::span<const Point> path, const Body& body, double speed,
                                    double from, const Rubble& rubble);

}  // namespace waybreaker
