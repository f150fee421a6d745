// The greedy method: again and again the one obstacle whose removal shortens the ground path most. Each step is
// proven by the crossing search, the whole is not: two obstacles may only gain together.

#include <chrono>

#include "experiment/evaluate.hpp"
#include "waybreaker/schedule.hpp"

namespace waybreaker::experiment {
namespace {

// Both agents in time on a ground path.
Stage scheduled(const Map& map, const Mission& mission, const CrossingResult& found,
                std::span<const ObstacleId> removed, Result& result) {
    Stage stage;
    stage.expanded = found.expanded;
    stage.generated = found.generated;
    if (found.status != SearchStatus::found) return stage;
    const Schedule schedule = best_schedule(map, {.ground_path = found.best.path,
                                                  .driver = mission.first(AgentKind::ground),
                                                  .flyer = mission.first(AgentKind::air),
                                                  .rules = mission.rules,
                                                  .removed = removed});
    stage.ground = found.best.length;
    stage.air = schedule.flight.length;
    stage.makespan = schedule.makespan;
    stage.flowtime = schedule.flowtime;
    result.removed.clear();
    for (const BreachPoint& breach : schedule.flight.breaches) result.removed.push_back(breach.obstacle);
    return stage;
}

}  // namespace

Result Evaluator::plan_greedily(const Map& map, const ExperimentMission& mission, int removals, const StopToken& stop) {
    Mission asked = ground_and_air(mission.start, mission.goal);
    asked.rules.removals = removals;
    validate(map, asked);
    const auto search = [&](int crossings, const std::vector<ObstacleId>& removed) {
        CrossingOptions options;
        options.crossings = crossings;
        options.removed = removed;
        options.limits.stop = stop;
        return crossing_.find(map, mission.start, mission.goal, options);
    };
    using Clock = std::chrono::steady_clock;
    Clock::time_point begin = Clock::now();
    const auto seconds = [&begin] { return std::chrono::duration<double>(Clock::now() - begin).count(); };
    Result result;
    result.before = result.after = scheduled(map, asked, search(0, {}), {}, result);
    result.before.seconds = result.after.seconds = seconds();
    begin = Clock::now();
    std::vector<ObstacleId> removed;
    while (std::ssize(removed) < removals) {
        const CrossingResult next = search(1, removed);
        if (next.best.crossed.empty()) break;
        removed.push_back(next.best.crossed.front());
        Result further = result;
        further.after = scheduled(map, asked, next, removed, further);
        const bool better =
            further.after.makespan && (!result.after.makespan || *further.after.makespan < *result.after.makespan);
        if (better) result = further;
        result.after.seconds = seconds();
    }
    result.status = result.after.makespan ? ResultStatus::solved : ResultStatus::no_plan;
    return result;
}

}  // namespace waybreaker::experiment
