#include "select/opening_times.hpp"

#include <algorithm>
#include <cmath>

namespace waybreaker {
namespace {

// Whether an aircraft can breach all that is removed just ahead of the ground agent, wherever that drives.
bool keeps_up(const Task& task, const Agent& agent) {
    return agent.begin() == Point(task.driver.start) && agent.ready_at <= task.driver.ready_at &&
           agent.speed >= task.driver.speed && agent.breaches >= task.rules.removals && agent.airspace.is_open() &&
           std::isinf(agent.longest_flight()) && !agent.can_breach;
}

bool is_timed(const Task& task) {
    return task.rules.timing == Timing::enforce && !task.opens_own_way();
}

bool may_open_late(const Task& task) {
    if (!is_timed(task)) return false;
    return std::ranges::none_of(task.aircraft, [&](const Agent* agent) { return keeps_up(task, *agent); }) ||
           std::ranges::any_of(task.map.obstacles(),
                               [&](const Obstacle& o) { return task.least_time_to_breach(o) > 0; });
}

// Whether flights past what is removed may end later than the drive, or be longer by more than a detour from it.
bool may_fly_longer(const Task& task) {
    if (!is_timed(task) || task.rules.objective == Objective::ground_makespan) return false;
    return std::ranges::none_of(
        task.aircraft, [&](const Agent* agent) { return keeps_up(task, *agent) && agent->goal == task.driver.goal; });
}

}  // namespace

OpeningTimes::OpeningTimes(const Task& task)
    : task_(task),
      earliest_(task.map, task.rules, task.aircraft),
      may_be_late_(may_open_late(task)),
      matter_(may_be_late_ || may_fly_longer(task)) {}

OpeningTimes OpeningTimes::at_once(const Task& task) {
    OpeningTimes times(task);
    times.may_be_late_ = times.matter_ = false;
    times.at_once_ = true;
    return times;
}

double OpeningTimes::cells(std::span<const ObstacleId> obstacles) {
    const double rubble = obstacles.empty() ? 0 : task_.rules.rubble;
    return task_.cells_until(earliest_.of(obstacles).open + rubble);
}

double OpeningTimes::flight_cells(std::span<const ObstacleId> obstacles) {
    Returns home = task_.least_flight;
    if (!obstacles.empty()) {
        const Returns& past_them = earliest_.of(obstacles).home;
        home = {std::max(home.last, past_them.last), std::max(home.sum, past_them.sum)};
    }
    const bool adds = task_.rules.objective == Objective::flowtime;
    return adds ? home.sum * task_.driver.speed : task_.cells_until(home.last);
}

}  // namespace waybreaker
