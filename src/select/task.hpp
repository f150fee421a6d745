// Task: what all steps of a mission's planning work on.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "core/stopwatch.hpp"
#include "drive/opening.hpp"
#include "model/objective.hpp"
#include "waybreaker/method.hpp"

namespace waybreaker {

inline constexpr double infinity = std::numeric_limits<double>::infinity();
// Relative: what is less is no gain.
inline constexpr double rounding = 1e-9;

struct Task {
    const Map& map;
    const Agent& driver;
    std::vector<const Agent*> aircraft;  // none: the driver breaches itself, or nothing is
    const Rules& rules;
    const Method& method;
    const Limits& limits;
    Deadline deadline;  // of the whole call
    // When the aircraft are home at the earliest: straight, or past what must be removed.
    Returns least_flight;
    bool reports = true;  // its progress
    // What is removed in every plan: what must be, and what opens by itself.
    std::vector<ObstacleId> given = {};
    // What the driver could drive while it breaches each obstacle itself, and gets through its rubble, by id, in cells;
    // empty if it does neither.
    std::vector<double> prices = {};

    // The planner that drives the ground agent.
    Algorithm planner() const { return planner_of(method, driver.body); }
    // The ground agent on its way.
    Trip trip() const {
        return {map,         driver,      search_options(method, driver.body), deadline, limits.expansions,
                limits.stop, rules.rubble};
    }
    // When a ground path and the flights end, as the objective counts it.
    double objective(double ground_time, const Returns& home) const;
    // When the ground agent arrives that drives so many cells without a wait, and how many it can drive until then.
    double arrival(double cells) const { return driver.ready_at + cells / driver.speed; }
    double cells_until(double time) const { return std::max(time - driver.ready_at, 0.0) * driver.speed; }
    bool opens_own_way() const { return driver.own_breaches > 0; }
    // No breach of it takes less; 0 where nobody may.
    double least_time_to_breach(const Obstacle& obstacle) const;
    // How many obstacles the aircraft may breach together, or the driver.
    std::int64_t capacity() const;
    // How many obstacles may be removed beside those that must be.
    int spare_removals() const { return rules.removals - int(rules.force.size()); }
    // What the others may weigh.
    double spare_budget() const;
    // What another plan must be below, to be worth looking for when that is reached.
    double worth(double reached) const { return reached / (1 + limits.gap); }
    void report(double best, double bound) const {
        if (reports && limits.progress) limits.progress({best, bound});
    }
    // Of those, what opens by itself.
    std::vector<ObstacleId> opened() const { return {given.begin() + std::ptrdiff_t(rules.force.size()), given.end()}; }
    // What is removed in every plan, and others.
    std::vector<ObstacleId> with_forced(std::span<const ObstacleId> others) const;
    // The same task, with that share of the time that is left.
    Task within(double share_of_time) const;
    // The same mission under other rules, without reports of progress. The rules must outlive it.
    Task under(const Rules& others) const { return under(others, map); }
    // On a map whose obstacles weigh something else, as well. The map must outlive it.
    Task under(const Rules& others, const Map& weighed) const;
};

// The task of a valid mission. The call's time begins now. All arguments must outlive it.
Task task_of(const Map& map, const Mission& mission, const Method& method, const Limits& limits);

// A lower bound of when the aircraft have breached all these and are home.
Returns least_return(const Task& task, std::span<const ObstacleId> removed);

// The task's limits, with so many seconds.
Limits limits_of(const Task& task, double seconds);

}  // namespace waybreaker
