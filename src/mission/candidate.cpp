#include "mission/candidate.hpp"

#include <algorithm>
#include <iterator>
#include <limits>

#include "core/stopwatch.hpp"
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

double Task::objective(double ground_time, double air_time) const {
    switch (rules.objective) {
        case Objective::makespan:
            return std::max(ground_time, air_time);
        case Objective::flowtime:
            return ground_time + air_time;
        case Objective::ground_makespan:
            break;
    }
    return ground_time;
}

std::vector<ObstacleId> Task::with_forced(std::span<const ObstacleId> others) const {
    std::vector<ObstacleId> all = rules.force;
    std::ranges::copy_if(others, std::back_inserter(all),
                         [&](ObstacleId id) { return std::ranges::find(rules.force, id) == rules.force.end(); });
    return all;
}

SearchOptions cell_search(const Task& task) {
    SearchOptions search = search_options(task.method, task.driver.body);
    if (search.planner == Planner::optimal) search.planner = Planner::theta;
    search.limits = task.limits;
    search.limits.seconds = task.deadline.left();
    return search;
}

Candidate candidate_of(std::vector<ObstacleId> removed, const SearchResult& search, double seconds) {
    Candidate candidate{std::move(removed), search.status, {}, search.status == SearchStatus::limit_reached};
    if (search.status == SearchStatus::found) candidate.ground.length = search.length;
    candidate.ground.expanded = search.expanded;
    candidate.ground.generated = search.generated;
    candidate.ground.seconds = seconds;
    candidate.ground.path.assign(search.path.begin(), search.path.end());
    return candidate;
}

Draft draft_of(const Task& task, Candidate candidate) {
    const Stopwatch watch;
    const std::vector<Point> nowhere{task.driver.start};
    const ScheduleTask asked{.ground_path = candidate.ground.path.empty() ? nowhere : candidate.ground.path,
                             .driver = task.driver,
                             .flyer = task.flyer,
                             .rules = task.rules,
                             .removed = candidate.removed,
                             .time_limit = task.deadline.left()};
    Schedule schedule =
        task.method.flight == FlightRule::optimal
            ? best_schedule(task.map, asked)
            : schedule_of(task.map, asked, fly_nearest(task.map, task.flyer.start, task.flyer.goal, asked.removed));
    return {std::move(candidate), std::move(schedule), watch.seconds()};
}

double cost(const Task& task, const Draft& draft) {
    if (!draft.candidate.ground.length) return std::numeric_limits<double>::infinity();
    return task.objective(draft.schedule.ground.back().t, draft.schedule.air.back().t);
}

const Draft& best_of(const Task& task, const Draft& nothing, const std::vector<Draft>& drafts) {
    if (drafts.empty()) return nothing;
    const Draft* best = task.rules.timing == Timing::ignore ? &drafts.back() : &nothing;
    for (const Draft& draft : drafts) {
        if (cost(task, draft) < cost(task, *best) * (1 - 1e-9)) best = &draft;
    }
    return best->candidate.ground.length ? *best : drafts.back();
}

}  // namespace waybreaker
