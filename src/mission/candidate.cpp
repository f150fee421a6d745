#include "mission/candidate.hpp"

#include <algorithm>
#include <limits>

#include "mission/stopwatch.hpp"
#include "waybreaker/flight.hpp"

namespace waybreaker {
namespace {

const Agent& agent_of(const Mission& mission, AgentKind kind) {
    return *std::ranges::find(mission.agents, kind, &Agent::kind);
}

}  // namespace

Task task_of(const Map& map, const Mission& mission, const MissionOptions& options) {
    return {map, agent_of(mission, AgentKind::ground), agent_of(mission, AgentKind::air), options};
}

double Task::radius() const {
    const Motion& motion = options.search.motion;
    return motion.corners == Corners::none ? motion.radius : 0;
}

double Task::objective(double ground_time, double air_time) const {
    return options.objective == Objective::makespan ? std::max(ground_time, air_time) : ground_time + air_time;
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
