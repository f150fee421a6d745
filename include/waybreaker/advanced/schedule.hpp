// Schedule: who is where when, so that the ground agent touches no obstacle before it has been breached.
//
//     Schedule s = best_schedule(map, {path, robot, drone, mission.rules, walls});
//     drive(s.ground);  // waits, where it must, at the last turn before an obstacle
//     fly(s.air);       // stays at each breach point until the obstacle is gone
#pragma once

#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "waybreaker/advanced/flight.hpp"
#include "waybreaker/map.hpp"
#include "waybreaker/plan.hpp"

namespace waybreaker {

// A ground path, the obstacles that it needs open, and who drives and flies: views of what has to outlive the task.
struct ScheduleTask {
    std::span<const Point> ground_path;  // turning points, at least one; waits happen there
    const Agent& driver;                 // stands at the first point until it is ready
    const Agent& flyer;
    const Rules& rules;  // of which count breach_time, objective and timing (ignore: nobody waits for an obstacle)
    std::span<const ObstacleId> removed = {};  // what the path needs open
    // Seconds that best_schedule may take; then it gives the best flight found by then. It always finds one.
    double time_limit = std::numeric_limits<double>::infinity();
};

struct Schedule {
    Flight flight;
    std::vector<Waypoint> ground;    // with waits: a point twice
    std::vector<Waypoint> air;       // with stays at breach points
    std::vector<double> cleared_at;  // as flight.breaches
    std::vector<std::optional<double>> entered_at;
    double makespan = 0;
    double flowtime = 0;
    bool optimal = false;  // proven: for this ground path no order or breach points are better
};

// The best flight for this ground path: order and breach points minimise the objective, waits included, and of equally
// good flights the other objective; proven for up to exact_flight_limit obstacles. Breaches all of task.removed, needed
// or not. It keeps to the flyer's range; where no flight was found that does, it is one that does not. Throws
// InputError for an obstacle that fills the whole map, for a path without points, and for speeds or times out of range.
// Precondition, here and below: all ids name obstacles of the map.
Schedule best_schedule(const Map& map, const ScheduleTask& task);

// The waits and stays that a given flight makes necessary. Throws InputError as best_schedule does.
Schedule schedule_of(const Map& map, const ScheduleTask& task, const Flight& flight);

}  // namespace waybreaker
