// Joint schedule: one ground agent and any number of aircraft that open its way.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "model/objective.hpp"
#include "waybreaker/advanced/schedule.hpp"

namespace waybreaker {

// As ScheduleTask. The aircraft may breach as many as have to be removed; without one, what is removed opens by itself.
struct JointTask {
    std::span<const Point> ground_path;
    const Agent& driver;
    std::span<const Agent* const> aircraft;
    const Rules& rules;
    std::span<const ObstacleId> removed = {};
    double time_limit = std::numeric_limits<double>::infinity();  // seconds
};

// A breach of a schedule.
struct TimedBreach {
    ObstacleId obstacle;
    std::size_t aircraft = 0;  // which one
    Cell at;
    double begun_at = 0;
    double cleared_at = 0;
    std::optional<double> entered_at = {};  // when the ground agent first touches the obstacle
};

struct JointSchedule {
    std::vector<Waypoint> ground = {};            // with waits: a point twice
    std::vector<std::vector<Waypoint>> air = {};  // of each aircraft, with stays at breach points
    std::vector<TimedBreach> breaches = {};       // in order of cleared_at
    Returns home = {};                            // infinity where no flights were found that are short enough

    double arrival() const { return ground.back().t; }
};

// The best flights for this ground path, by the objective. Of one aircraft that does not recharge: best_schedule. Of
// several: the best way to share the obstacles among them, each share flown at its best, where there are few of both;
// that is the best there is for the makespan and the ground makespan. Else, where any recharges, and for the flowtime,
// local search. Flights keep to the aircraft's ranges; where such were not found, others are given.
JointSchedule best_joint_schedule(const Map& map, const JointTask& task);

// One aircraft, which flies by the paper's rule (fly_nearest).
JointSchedule nearest_schedule(const Map& map, const JointTask& task);

}  // namespace waybreaker
