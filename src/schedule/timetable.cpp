#include "schedule/timetable.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "plan/timeline.hpp"

namespace waybreaker {

Schedule timetable(const ScheduleTask& task, const Flight& flight, std::span<const Breaching> breachings) {
    assert(!task.ground_path.empty() && breachings.size() == flight.breaches.size());
    Schedule schedule;
    schedule.flight = flight;

    // The air agent stays at each breach point until the obstacle is gone.
    const auto fly_to = [&](Cell to) {
        const Waypoint& from = schedule.air.back();
        const double t = from.t + distance(Point(from.x, from.y), to) / task.air_speed;
        schedule.air.push_back({double(to.x), double(to.y), t});
    };
    schedule.air.push_back({double(task.air_start.x), double(task.air_start.y), 0});
    for (std::size_t i = 0; i < breachings.size(); ++i) {
        fly_to(flight.breaches[i].at);
        Waypoint there = schedule.air.back();
        there.t += breachings[i].stay;
        if (breachings[i].stay > 0) schedule.air.push_back(there);
        schedule.cleared_at.push_back(there.t);
    }
    fly_to(task.air_goal);

    // The ground agent waits for each obstacle at the last turn before it touches it: how long it is delayed from each
    // turn on.
    const std::vector<Waypoint> turns = timed(task.ground_path, task.ground_speed);
    const auto turn_before = [&](double entry) {
        const auto after = std::ranges::upper_bound(turns, entry, {}, &Waypoint::t);
        return std::size_t(after - turns.begin()) - 1;
    };
    std::vector<double> delays(turns.size(), 0);
    for (std::size_t i = 0; i < breachings.size(); ++i) {
        if (std::isinf(breachings[i].entry)) continue;
        double& delay = delays[turn_before(breachings[i].entry)];
        delay = std::max(delay, schedule.cleared_at[i] - breachings[i].entry);
    }
    const double rounding = 1e-9 * (1 + schedule.air.back().t);
    double delay = 0;
    for (std::size_t i = 0; i < turns.size(); ++i) {
        schedule.ground.push_back({turns[i].x, turns[i].y, turns[i].t + delay});
        if (delays[i] > delay + rounding) {
            delay = delays[i];
            schedule.ground.push_back({turns[i].x, turns[i].y, turns[i].t + delay});
        }
        delays[i] = delay;
    }
    for (std::size_t i = 0; i < breachings.size(); ++i) {
        const double entry = breachings[i].entry;
        schedule.entered_at.emplace_back();
        if (std::isinf(entry)) continue;
        schedule.entered_at.back() = std::max(entry + delays[turn_before(entry)], schedule.cleared_at[i]);
    }

    schedule.makespan = std::max(schedule.ground.back().t, schedule.air.back().t);
    schedule.flowtime = schedule.ground.back().t + schedule.air.back().t;
    return schedule;
}

Schedule schedule_of(const Map& map, const ScheduleTask& task, const Flight& flight) {
    const std::vector<Waypoint> driven = timed(task.ground_path, task.ground_speed);
    std::vector<Breaching> breachings;
    for (const BreachPoint& breach : flight.breaches) {
        const std::optional<double> entry = first_touch(map, breach.obstacle, driven, task.radius);
        breachings.push_back({entry.value_or(std::numeric_limits<double>::infinity()),
                              task.breach_time.of(map.obstacle(breach.obstacle))});
    }
    return timetable(task, flight, breachings);
}

}  // namespace waybreaker
