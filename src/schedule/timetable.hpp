// Timetable: a ground path and a flight with times, given when the ground agent comes to each obstacle.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "waybreaker/advanced/schedule.hpp"

namespace waybreaker {

// An obstacle as the timetable sees it. Times are those of a ground agent that stops for nothing but rubble.
struct Breaching {
    std::optional<double> touched;  // when the ground agent first touches the obstacle
    double needed_by = 0;           // when it must be gone, so long before as its rubble takes; infinity: any time
    double stay = 0;                // how long the air agent stays until it is gone
};

// Throws InputError if speeds or breach times are out of range.
void validate(const ScheduleTask& task);

// The ground path in time, with stops for rubble only.
std::vector<Waypoint> drive_through(const Map& map, const ScheduleTask& task);
// `driven`: that.
Breaching breaching_of(const Map& map, const ScheduleTask& task, std::span<const Waypoint> driven, ObstacleId obstacle);

// An obstacle that opens by itself (Rules::opened), in the way of a ground agent that comes to it then.
struct Due {
    double needed_by = 0;
    double opens = 0;
};
// Those on the path that open late; none where obstacles do not stand in time. `driven`: as above.
std::vector<Due> given_of(const Map& map, const ScheduleTask& task, std::span<const Waypoint> driven);
// Those that an aircraft has to breach, in their order.
std::vector<ObstacleId> to_breach(const Rules& rules, std::span<const ObstacleId> removed);

// The ground agent of a task in time.
struct TimedDrive {
    std::vector<Waypoint> path;                     // with waits: a point twice
    std::vector<std::optional<double>> entered_at;  // as the breachings: when it first touches each obstacle
};
// It waits for each obstacle at the last turn before it touches it. `turns`: drive_through(). `cleared`: as the
// breachings; a delay is one that is longer than `rounding`.
TimedDrive drive_in_time(std::span<const Waypoint> turns, const Rules& rules, std::span<const Breaching> breachings,
                         std::span<const double> cleared, std::span<const Due> given, double rounding);

// `driven`: drive_through(). `breachings` as flight.breaches.
Schedule timetable(const ScheduleTask& task, std::span<const Waypoint> driven, const Flight& flight,
                   std::span<const Breaching> breachings, std::span<const Due> given);

}  // namespace waybreaker
