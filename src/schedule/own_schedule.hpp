// Own schedule: a ground agent that breaches what is in its way itself.
#pragma once

#include <span>

#include "schedule/joint_schedule.hpp"

namespace waybreaker {

// Along its path it stands where it first touches an obstacle, until it has breached it or, if it opens by itself,
// until it is open. Of `removed` it breaches those that it touches, in that order; no flights. REQUIRES: a path with a
// point.
JointSchedule own_schedule(const Map& map, const Agent& driver, const Rules& rules, std::span<const Point> path,
                           std::span<const ObstacleId> removed);

}  // namespace waybreaker
