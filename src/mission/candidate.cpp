#include "mission/candidate.hpp"

#include <algorithm>
#include <iterator>
#include <limits>

#include "mission/stopwatch.hpp"
#include "waybreaker/flight.hpp"

namespace waybreaker {
namespace {

const Agent& agent_of(const Mission& mission, AgentKind kind) {
    return *std::ranges::find(mission.agents, kind, &Agent::kind);
}

double least_flight(const Map& map, const Agent& flyer, const MissionOptions& options) {
    double time = fly_optimal(map, flyer.start, flyer.goal, options.force).length / flyer.speed;
    for (const ObstacleId id : options.force) time += options.breach_time.of(map.obstacle(id));
    return time;
}

}  // namespace

Task task_of(const Map& map, const Mission& mission, const MissionOptions& options) {
    const Agent& flyer = agent_of(mission, AgentKind::air);
    return {map, agent_of(mission, AgentKind::ground), flyer, options, least_flight(map, flyer, options)};
}

Task task_of(const Task& task, const MissionOptions& options) {
    return {task.map, task.driver, task.flyer, options, least_flight(task.map, task.flyer, options)};
}

double Task::radius() const {
    const Motion& motion = options.search.motion;
    return motion.corners == Corners::none ? motion.radius : 0;
}

double Task::objective(double ground_time, double air_time) const {
    return options.objective == Objective::makespan ? std::max(ground_time, air_time) : ground_time + air_time;
}

std::vector<ObstacleId> Task::with_forced(std::span<const ObstacleId> others) const {
    std::vector<ObstacleId> all = options.force;
    std::ranges::copy_if(others, std::back_inserter(all),
                         [&](ObstacleId id) { return std::ranges::find(options.force, id) == options.force.end(); });
    return all;
}

Candidate candidate_of(std::vector<ObstacleId> removed, const SearchResult& search, double seconds) {
    Candidate candidate{std::move(removed), search.status, {}};
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
                            .objective = task.options.objective};
    Schedule schedule =
        task.options.flight == FlightRule::optimal
            ? best_schedule(task.map, wish)
            : schedule_of(task.map, wish, fly_nearest(task.map, wish.air_start, wish.air_goal, wish.removed));
    return {std::move(candidate), std::move(schedule), watch.seconds()};
}

double cost(const Task& task, const Draft& draft) {
    if (!draft.candidate.ground.length) return std::numeric_limits<double>::infinity();
    return task.options.objective == Objective::makespan ? draft.schedule.makespan : draft.schedule.flowtime;
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
