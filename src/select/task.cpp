#include "select/task.hpp"

#include <algorithm>
#include <iterator>

#include "plan/objective.hpp"
#include "waybreaker/flight.hpp"

namespace waybreaker {

double least_flight_time(const Task& task, std::span<const ObstacleId> removed) {
    const Agent& flyer = task.flyer;
    // The flight past all of them is no shorter than the one past as many as are solved with proof.
    const auto solved = removed.first(std::min(removed.size(), exact_flight_limit));
    double time = fly_optimal(task.map, flyer.start, flyer.goal, solved).length / flyer.speed;
    for (const ObstacleId id : removed) time += task.rules.breach_time.of(task.map.obstacle(id));
    return time;
}

Task task_of(const Map& map, const Mission& mission, const Method& method, const Limits& limits) {
    const Agent& driver = mission.first(AgentKind::ground);
    const Agent& flyer = mission.first(AgentKind::air);
    Task task{map, driver, flyer, mission.rules, method, limits, Deadline(limits.seconds), 0};
    task.least_flight = least_flight_time(task, task.rules.force);
    return task;
}

Task Task::under(const Rules& others) const {
    Task task{map, driver, flyer, others, method, limits, deadline, 0, false};
    task.least_flight = least_flight_time(task, others.force);
    return task;
}

Task Task::within(double share_of_time) const {
    Task task = *this;
    task.deadline = deadline.share(share_of_time);
    return task;
}

double Task::objective(double ground_time, double air_time) const {
    return rank(rules.objective, finish_of_two(ground_time, air_time)).first;
}

double Task::spare_budget() const {
    double budget = rules.budget;
    for (const ObstacleId id : rules.force) budget -= map.obstacle(id).weight;
    return budget;
}

std::vector<ObstacleId> Task::with_forced(std::span<const ObstacleId> others) const {
    std::vector<ObstacleId> all = rules.force;
    std::ranges::copy_if(others, std::back_inserter(all),
                         [&](ObstacleId id) { return std::ranges::find(rules.force, id) == rules.force.end(); });
    return all;
}

Limits limits_of(const Task& task, double seconds) {
    return {.seconds = seconds, .expansions = task.limits.expansions, .stop = task.limits.stop};
}

}  // namespace waybreaker
