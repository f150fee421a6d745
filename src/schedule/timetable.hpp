// Timetable: a ground path and a flight with times, given when the ground agent comes to each obstacle.
#pragma once

#include <span>

#include "waybreaker/schedule.hpp"

namespace waybreaker {

struct Breaching {
    double entry = 0;  // when the ground agent touches the obstacle if it never waits; infinity if it does not
    double stay = 0;   // how long the air agent stays until the obstacle is gone
};

// `breachings` as flight.breaches.
Schedule timetable(const ScheduleTask& task, const Flight& flight, std::span<const Breaching> breachings);

}  // namespace waybreaker
