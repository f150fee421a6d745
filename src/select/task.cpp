#include "select/task.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "schedule/earliest_openings.hpp"
#include "schedule/timetable.hpp"
#include "waybreaker/advanced/flight.hpp"

namespace waybreaker {
namespace {

std::vector<ObstacleId> given_by(const Rules& rules) {
    std::vector<ObstacleId> given = rules.force;
    for (const TimedOpening& opening : rules.opened) given.push_back(opening.obstacle);
    return given;
}

std::vector<double> prices_of(const Map& map, const Agent& driver, const Rules& rules) {
    std::vector<double> prices{0};
    for (const Obstacle& obstacle : map.obstacles()) {
        const double breach = driver.own_breaches > 0 ? time_to_breach(driver, obstacle, rules) : 0;
        // What it may not breach is protected, whatever its price.
        prices.push_back(((std::isfinite(breach) ? breach : 0) + rules.rubble) * driver.speed);
    }
    return prices;
}

// What is forced may be out of range together: then there is no plan, whatever is a bound.
Returns least_flight_of(const Task& task) {
    const Returns home = least_return(task, task.rules.force);
    return std::isinf(home.last) ? Returns{} : home;
}

}  // namespace

Returns least_return(const Task& task, std::span<const ObstacleId> removed) {
    if (task.aircraft.empty()) return {};
    if (task.aircraft.size() > 1) return EarliestOpenings(task.map, task.rules, task.aircraft).of(removed).home;
    const Agent& flyer = *task.aircraft.front();
    // The flight past all of them is no shorter than the one past as many as are solved with proof.
    const std::vector<ObstacleId> breached = to_breach(task.rules, removed);
    const auto solved = std::span(breached).first(std::min(breached.size(), exact_flight_limit));
    double time =
        flyer.ready_at + fly_optimal(task.map, flyer.begin(), flyer.goal, solved, flyer.airspace).length / flyer.speed;
    for (const ObstacleId id : breached) time += time_to_breach(flyer, task.map.obstacle(id), task.rules);
    return {time, time};
}

Task task_of(const Map& map, const Mission& mission, const Method& method, const Limits& limits) {
    std::vector<const Agent*> aircraft;
    for (const Agent& agent : mission.agents) {
        if (agent.kind == AgentKind::air) aircraft.push_back(&agent);
    }
    const Agent& driver = mission.first(AgentKind::ground);
    Task task{map, driver, std::move(aircraft), mission.rules, method, limits, Deadline(limits.seconds), {}};
    task.given = given_by(mission.rules);
    if (task.opens_own_way() || mission.rules.rubble > 0) task.prices = prices_of(map, driver, mission.rules);
    task.least_flight = least_flight_of(task);
    return task;
}

Task Task::under(const Rules& others, const Map& weighed) const {
    Task task{weighed, driver, aircraft, others, method, limits, deadline, {}, false};
    task.given = given_by(others);
    task.prices = prices;
    task.least_flight = least_flight_of(task);
    return task;
}

Task Task::within(double share_of_time) const {
    Task task = *this;
    task.deadline = deadline.share(share_of_time);
    return task;
}

double Task::objective(double ground_time, const Returns& home) const {
    return rank(rules.objective, finish_of(ground_time, home)).first;
}

double Task::least_time_to_breach(const Obstacle& obstacle) const {
    double least = infinity;
    for (const Agent* agent : aircraft) least = std::min(least, time_to_breach(*agent, obstacle, rules));
    if (opens_own_way()) least = time_to_breach(driver, obstacle, rules);
    return std::isfinite(least) ? least : 0;
}

std::int64_t Task::capacity() const {
    std::int64_t breaches = driver.own_breaches;
    for (const Agent* agent : aircraft) breaches += agent->breaches;
    return breaches;
}

double Task::spare_budget() const {
    double budget = rules.budget;
    for (const ObstacleId id : rules.force) budget -= map.obstacle(id).weight;
    return budget;
}

std::vector<ObstacleId> Task::with_forced(std::span<const ObstacleId> others) const {
    std::vector<ObstacleId> all = given;
    std::ranges::copy_if(others, std::back_inserter(all),
                         [&](ObstacleId id) { return std::ranges::find(given, id) == given.end(); });
    return all;
}

Limits limits_of(const Task& task, double seconds) {
    return {.seconds = seconds, .expansions = task.limits.expansions, .stop = task.limits.stop};
}

}  // namespace waybreaker
