#include "mission/candidate.hpp"

#include <algorithm>
#include <iterator>
#include <limits>

#include "core/stopwatch.hpp"
#include "waybreaker/flight.hpp"

namespace waybreaker {
namespace {

const Agent& agent_of(const Mission& mission, AgentKind kind) {
    return *std::ranges::find(mission.agents, kind, &Agent::kind);
}

}  // namespace

double least_flight_time(const Map& map, const Agent& flyer, std::span<const ObstacleId> removed,
                         const MissionOptions& options) {
    // The flight past all of them is no shorter than the one past as many as are solved with proof.
    const auto solved = removed.first(std::min(removed.size(), exact_flight_limit));
    double time = fly_optimal(map, flyer.start, flyer.goal, solved).length / flyer.speed;
    for (const ObstacleId id : removed) time += options.breach_time.of(map.obstacle(id));
    return time;
}

Task task_of(const Map& map, const Mission& mission, const MissionOptions& options) {
    const Agent& flyer = agent_of(mission, AgentKind::air);
    const Deadline deadline(options.time_limit);
    const double least_flight = least_flight_time(map, flyer, options.force, options);
    return {map, agent_of(mission, AgentKind::ground), flyer, options, deadline, least_flight};
}

Task task_of(const Task& task, const MissionOptions& options) {
    const double least_flight = least_flight_time(task.map, task.flyer, options.force, options);
    return {task.map, task.driver, task.flyer, options, task.deadline, least_flight};
}

double Task::radius() const {
    const Motion& motion = options.search.motion;
    return motion.corners == Corners::none ? motion.radius : 0;
}

double Task::objective(double ground_time, double air_time) const {
    switch (options.objective) {
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
    std::vector<ObstacleId> all = options.force;
    std::ranges::copy_if(others, std::back_inserter(all),
                         [&](ObstacleId id) { return std::ranges::find(options.force, id) == options.force.end(); });
    return all;
}

SearchOptions cell_search(const Task& task) {
    SearchOptions search = task.options.search;
    if (search.planner == Planner::optimal) {
        search.planner = Planner::theta;
        if (task.radius() == 0) search.motion = {.corners = Corners::squeeze};  // as a point goes
    }
    search.time_limit = std::min(search.time_limit, task.deadline.left());
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
    const ScheduleTask wish{.ground_path = candidate.ground.path.empty() ? nowhere : candidate.ground.path,
                            .ground_speed = task.driver.speed,
                            .radius = task.radius(),
                            .slips = task.options.search.motion.corners != Corners::cut,
                            .air_start = task.flyer.start,
                            .air_goal = task.flyer.goal,
                            .air_speed = task.flyer.speed,
                            .removed = candidate.removed,
                            .breach_time = task.options.breach_time,
                            .timing = task.options.timing,
                            .objective = task.options.objective,
                            .time_limit = task.deadline.left()};
    Schedule schedule =
        task.options.flight == FlightRule::optimal
            ? best_schedule(task.map, wish)
            : schedule_of(task.map, wish, fly_nearest(task.map, wish.air_start, wish.air_goal, wish.removed));
    return {std::move(candidate), std::move(schedule), watch.seconds()};
}

double cost(const Task& task, const Draft& draft) {
    if (!draft.candidate.ground.length) return std::numeric_limits<double>::infinity();
    return task.objective(draft.schedule.ground.back().t, draft.schedule.air.back().t);
}

const Draft& best_of(const Task& task, const Draft& nothing, const std::vector<Draft>& drafts) {
    if (drafts.empty()) return nothing;
    const Draft* best = task.options.timing == Timing::ignore ? &drafts.back() : &nothing;
    for (const Draft& draft : drafts) {
        if (cost(task, draft) < cost(task, *best) * (1 - 1e-9)) best = &draft;
    }
    return best->candidate.ground.length ? *best : drafts.back();
}

}  // namespace waybreaker
