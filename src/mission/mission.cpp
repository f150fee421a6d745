// From mission to plan. plan() reads as the paper's section 3, with time.
#include "waybreaker/mission.hpp"

#include "mission/candidate.hpp"
#include "mission/hits.hpp"
#include "mission/stopwatch.hpp"

namespace waybreaker {
namespace {

Outcome outcome(const Task& task, const Draft& draft) {
    Outcome result;
    result.ground = draft.candidate.ground;
    result.air.length = draft.schedule.flight.length;
    result.air.path.push_back(task.flyer.start);
    for (const BreachPoint& breach : draft.schedule.flight.breaches) result.air.path.push_back(breach.at);
    result.air.path.push_back(task.flyer.goal);
    if (result.ground.length) {
        result.makespan = draft.schedule.makespan;
        result.flowtime = draft.schedule.flowtime;
    }
    return result;
}

PlanStatus plan_status(SearchStatus search) {
    switch (search) {
        case SearchStatus::found:
            return PlanStatus::solved;
        case SearchStatus::limit_reached:
            return PlanStatus::limit_reached;
        case SearchStatus::stopped:
            return PlanStatus::stopped;
        case SearchStatus::no_path:
            break;
    }
    return PlanStatus::no_plan;
}

std::vector<Removal> removals(const Task& task, const Schedule& schedule, std::span<const std::uint32_t> hits) {
    std::vector<Removal> removed;
    for (std::size_t i = 0; i < schedule.flight.breaches.size(); ++i) {
        const BreachPoint& breach = schedule.flight.breaches[i];
        const Obstacle& obstacle = task.map.obstacle(breach.obstacle);
        removed.push_back({.obstacle = obstacle.id,
                           .source_id = obstacle.source_id,
                           .cells = obstacle.cells,
                           .hits = hits[obstacle.id.value],
                           .at = breach.at,
                           .cleared_at = schedule.cleared_at[i],
                           .entered_at = schedule.entered_at[i]});
    }
    return removed;
}

}  // namespace

Plan MissionPlanner::plan(const Map& map, const Mission& mission, const MissionOptions& options) {
    validate(map, mission, options);
    const Task task = task_of(map, mission, options);
    const Stopwatch total;

    // Search the ground path and count how often each obstacle is in the way.
    SearchOptions counting = options.search;
    counting.count_hits = true;
    const Stopwatch searching;
    const SearchResult search = searcher_.find(OpenedMap(map), task.driver.start, task.driver.goal, counting);
    const Draft nothing = draft_of(task, candidate_of({}, search, searching.seconds()));

    // Select the obstacles to remove.
    const Stopwatch selecting;
    const std::vector<ObstacleId> chosen = chosen_by_hits(task, search.hits);
    const double select_seconds = selecting.seconds();

    // Replan the ground path on the opened map, fly past the obstacles, and put both in time.
    const std::vector<Draft> drafts = drafts_by_hits(task, searcher_, nothing, chosen);
    const Draft& best = best_of(task, nothing, drafts);

    // Report both, without removal and with the best.
    Plan plan;
    plan.status = plan_status(best.candidate.status);
    plan.before = outcome(task, nothing);
    plan.after = outcome(task, best);
    plan.removed = removals(task, best.schedule, search.hits);
    if (plan.status == PlanStatus::solved) {
        for (const Agent& agent : mission.agents) {
            const std::vector<Waypoint>& path =
                agent.kind == AgentKind::ground ? best.schedule.ground : best.schedule.air;
            plan.agents.push_back({agent.id, agent.kind, agent.speed, path, agent.start, agent.goal});
        }
    }
    plan.seconds.search = nothing.candidate.ground.seconds;
    plan.seconds.select = select_seconds;
    for (const Draft& draft : drafts) {
        plan.seconds.search += draft.candidate.ground.seconds;
        plan.seconds.flight += draft.flight_seconds;
    }
    plan.seconds.total = total.seconds();
    return plan;
}

}  // namespace waybreaker
