// A vehicle's path as its moves, in place and time. What it waits is between them.
#pragma once

#include <cstddef>
#include <vector>

#include "safe_interval/motion.hpp"
#include "waybreaker/plan.hpp"

namespace waybreaker::orders {

// Moments lie by so much on the safe side, in cells; more than rounding of places.
inline constexpr double hair = 1e-9;

// How much earlier `before` is than `after`; 0 where that is less than rounding.
double slack_of(double before, double after);

// The moment before a share of a move.
Moment departure(std::size_t agent, const std::vector<Waypoint>& path, std::size_t move, double share);

// A move. Places on it are given as cells from its start.
struct Stretch {
    safe_interval::Vector start;
    safe_interval::Vector direction;  // of length 1; 0 of one that never moves
    double length = 0;
    std::size_t agent = 0;
    std::size_t point = 0;  // of the path: it leaves from here ...
    double leaves = 0;      // ... at that time
    std::size_t end = 0;  // and has passed the stretch when it has got there; one that leaves its goal, when it is gone
    double passed = 0;    // infinity: it stays

    // When it is at that place on its way.
    double time(double place) const;
    // Where it has got to by that time; below 0 before it leaves.
    double reached(double time) const;
    Moment arrival(double place) const;
    Moment departure(double place) const;
};

// One for each move; of an agent that never moves a single one. `stays`: at its goal.
std::vector<Stretch> stretches(std::size_t agent, const std::vector<Waypoint>& path, bool stays);

}  // namespace waybreaker::orders
