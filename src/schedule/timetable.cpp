#include "schedule/timetable.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

#include "core/range.hpp"
#include "model/rubble.hpp"
#include "model/timeline.hpp"
#include "schedule/tour_times.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker {
namespace {

// How long the obstacle must have been gone when the ground agent enters it.
double rubble_of(const Map& map, const ScheduleTask& task, ObstacleId obstacle) {
    const bool is_left = task.rules.rubble > 0 && !stands_in(map, obstacle, task.ground_path.front(), task.driver.body);
    return is_left ? task.rules.rubble : 0;
}

}  // namespace

void validate(const ScheduleTask& task) {
    if (task.ground_path.empty()) throw InputError("the ground agent's path has no points");
    require_range(task.driver.speed, least_speed, most_speed, "the ground agent's speed");
    require_range(task.flyer.speed, least_speed, most_speed, "the air agent's speed");
    require_range(task.driver.ready_at, 0, most_breach_time, "the time at which the ground agent is ready");
    require_range(task.rules.breach_time.per_obstacle, 0, most_breach_time, "the time of a breach");
    require_range(task.rules.rubble, 0, most_breach_time, "the time that rubble takes");
    require_range(task.rules.breach_time.per_cell, 0, most_breach_time, "the time of a breach for each cell");
}

std::vector<Waypoint> drive_through(const Map& map, const ScheduleTask& task) {
    std::vector<ObstacleId> open = to_breach(task.rules, task.removed);
    for (const TimedOpening& opening : task.rules.opened) open.push_back(opening.obstacle);
    return timed_through(map, task.ground_path, task.driver.body, task.driver.speed, task.driver.ready_at,
                         {open, task.rules.rubble});
}

Breaching breaching_of(const Map& map, const ScheduleTask& task, std::span<const Waypoint> driven,
                       ObstacleId obstacle) {
    Breaching breaching{first_touch(map, obstacle, driven, task.driver.body.reach()),
                        std::numeric_limits<double>::infinity(),
                        time_to_breach(task.flyer, map.obstacle(obstacle), task.rules)};
    if (task.rules.timing == Timing::ignore) return breaching;
    const double radius = standing_radius(task.driver.body);
    const auto needed_by =
        radius == task.driver.body.reach() ? breaching.touched : first_touch(map, obstacle, driven, radius);
    if (needed_by) breaching.needed_by = *needed_by - rubble_of(map, task, obstacle);
    return breaching;
}

std::vector<Due> given_of(const Map& map, const ScheduleTask& task, std::span<const Waypoint> driven) {
    std::vector<Due> given;
    if (task.rules.timing == Timing::ignore) return given;
    for (const TimedOpening& opening : task.rules.opened) {
        const auto needed_by = first_touch(map, opening.obstacle, driven, standing_radius(task.driver.body));
        const double rubble = rubble_of(map, task, opening.obstacle);
        if (needed_by && *needed_by - rubble < opening.at) given.push_back({*needed_by - rubble, opening.at});
    }
    return given;
}

std::vector<ObstacleId> to_breach(const Rules& rules, std::span<const ObstacleId> removed) {
    std::vector<ObstacleId> rest(removed.begin(), removed.end());
    std::erase_if(rest, [&](ObstacleId id) {
        return std::ranges::find(rules.opened, id, &TimedOpening::obstacle) != rules.opened.end();
    });
    return rest;
}

TimedDrive drive_in_time(std::span<const Waypoint> turns, const Rules& rules, std::span<const Breaching> breachings,
                         std::span<const double> cleared, std::span<const Due> given, double rounding) {
    TimedDrive driven;
    // How long it is delayed from each turn on.
    const auto turn_before = [&](double entry) {
        const auto after = std::ranges::upper_bound(turns, entry, {}, &Waypoint::t);
        // What is needed at once may be needed a hair before.
        return after == turns.begin() ? std::size_t{0} : std::size_t(after - turns.begin()) - 1;
    };
    std::vector<double> delays(turns.size(), 0);
    for (std::size_t i = 0; i < breachings.size(); ++i) {
        if (std::isinf(breachings[i].needed_by)) continue;
        double& delay = delays[turn_before(breachings[i].needed_by)];
        delay = std::max(delay, cleared[i] - breachings[i].needed_by);
    }
    for (const Due& due : given) {
        double& delay = delays[turn_before(due.needed_by)];
        delay = std::max(delay, due.opens - due.needed_by);
    }
    double delay = 0;
    for (std::size_t i = 0; i < turns.size(); ++i) {
        const double arrival = i == 0 ? 0 : turns[i].t + delay;
        driven.path.push_back({turns[i].x, turns[i].y, arrival});
        if (delays[i] > delay + rounding) delay = delays[i];
        const double departure = turns[i].t + delay;
        if (departure > arrival) driven.path.push_back({turns[i].x, turns[i].y, departure});
        delays[i] = delay;
    }
    for (std::size_t i = 0; i < breachings.size(); ++i) {
        std::optional<double>& entered = driven.entered_at.emplace_back(breachings[i].touched);
        if (!entered) continue;
        *entered += delays[turn_before(*entered)];
        if (rules.timing == Timing::enforce) entered = std::max(*entered, cleared[i]);
    }
    return driven;
}

Schedule timetable(const ScheduleTask& task, std::span<const Waypoint> driven, const Flight& flight,
                   std::span<const Breaching> breachings, std::span<const Due> given) {
    assert(!task.ground_path.empty() && breachings.size() == flight.breaches.size());
    Schedule schedule;
    schedule.flight = flight;
    // The air agent stays at each breach point until the obstacle is gone.
    Tour tour;
    for (const BreachPoint& breach : flight.breaches) tour.push_back({tour.size(), breach.at});
    const auto stay = [&](std::size_t target) { return breachings[target].stay; };
    schedule.air = flown(task.flyer, tour, stay);
    fly(task.flyer, tour, stay, [&](const Stop&, double, double cleared) { schedule.cleared_at.push_back(cleared); });
    const double rounding = 1e-9 * (1 + schedule.air.back().t);
    TimedDrive in_time = drive_in_time(driven, task.rules, breachings, schedule.cleared_at, given, rounding);
    schedule.ground = std::move(in_time.path);
    schedule.entered_at = std::move(in_time.entered_at);

    schedule.makespan = std::max(schedule.ground.back().t, schedule.air.back().t);
    schedule.flowtime = schedule.ground.back().t + schedule.air.back().t;
    return schedule;
}

Schedule schedule_of(const Map& map, const ScheduleTask& task, const Flight& flight) {
    validate(task);
    const std::vector<Waypoint> driven = drive_through(map, task);
    std::vector<Breaching> breachings;
    for (const BreachPoint& breach : flight.breaches) {
        breachings.push_back(breaching_of(map, task, driven, breach.obstacle));
    }
    return timetable(task, driven, flight, breachings, given_of(map, task, driven));
}

}  // namespace waybreaker
