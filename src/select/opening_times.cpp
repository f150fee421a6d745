#include "select/opening_times.hpp"

#include <algorithm>
#include <cmath>

namespace waybreaker {
namespace {

bool may_matter(const Task& task) {
    if (task.rules.timing == Timing::ignore || task.opens_own_way()) return false;
    const auto keeps_up = [&](const Agent* agent) {
        return agent->begin() == Point(task.driver.start) && agent->ready_at <= task.driver.ready_at &&
               agent->speed >= task.driver.speed && agent->breaches >= task.rules.removals &&
               agent->airspace.is_open() && std::isinf(agent->longest_flight()) && !agent->can_breach;
    };
    return std::ranges::none_of(task.aircraft, keeps_up) ||
           std::ranges::any_of(task.map.obstacles(),
                               [&](const Obstacle& o) { return task.least_time_to_breach(o) > 0; });
}

}  // namespace

OpeningTimes::OpeningTimes(const Task& task)
    : task_(task), earliest_(task.map, task.rules, task.aircraft), matter_(may_matter(task)) {}

OpeningTimes OpeningTimes::at_once(const Task& task) {
    OpeningTimes times(task);
    times.matter_ = false;
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
