#include "experiment/evaluate.hpp"

#include <chrono>
#include <new>

#include "waybreaker/error.hpp"

namespace waybreaker::experiment {
namespace {

waybreaker::Method method_of(const Configuration& configuration, Mission& mission) {
    mission.rules.removals = configuration.removals;
    waybreaker::Method method;
    switch (configuration.method) {
        case Method::paper:
            follow_paper(mission.rules, method);
            break;
        case Method::none:
            method.select = Selection::none;
            mission.rules.timing = Timing::ignore;
            mission.rules.force.clear();
            break;
        case Method::greedy:
            method.select = Selection::greedy;
            break;
        case Method::exact:
            break;
    }
    method.planner = configuration.planner;
    method.weight = configuration.weight;
    return method;
}

Stage stage_of(const Outcome& outcome) {
    Stage stage{.ground = 0, .makespan = outcome.makespan, .flowtime = outcome.flowtime};
    for (const Route& route : outcome.routes) {
        if (route.kind == AgentKind::air) {
            stage.air += route.length.value_or(0);
            continue;
        }
        stage.expanded += route.expanded;
        stage.generated += route.generated;
        stage.seconds += route.seconds;
        stage.ground = stage.ground && route.length ? std::optional(*stage.ground + *route.length) : std::nullopt;
    }
    return stage;
}

ResultStatus status_of(PlanStatus status) {
    switch (status) {
        case PlanStatus::solved:
            return ResultStatus::solved;
        case PlanStatus::not_found:  // of teams only
        case PlanStatus::limit_reached:
        case PlanStatus::stopped:
            return ResultStatus::timed_out;
        case PlanStatus::no_plan:
            break;
    }
    return ResultStatus::no_plan;
}

}  // namespace

Result Evaluator::plan(const Map& map, const ExperimentMission& mission, const Configuration& configuration,
                       const StopToken& stop) {
    Mission asked = mission.mission;
    const waybreaker::Method method = method_of(configuration, asked);
    const Plan plan = planner_.plan(map, asked, method, {.stop = stop});
    Result result{.status = status_of(plan.status),
                  .before = stage_of(plan.before),
                  .after = stage_of(plan.after),
                  .bound = plan.bound,
                  .gap = plan.gap};
    for (const Breach& breach : plan.breaches) result.removed.push_back(breach.obstacle);
    return result;
}

Result Evaluator::evaluate(const Map& map, const ExperimentMission& mission, const Configuration& configuration,
                           const StopToken& stop) {
    const auto begin = std::chrono::steady_clock::now();
    Result result;
    try {
        result = plan(map, mission, configuration, stop);
        // The exact method returns the best plan so far, but a result that depends on the clock is not reproducible.
        if (stop.stop_requested()) result = {.status = ResultStatus::timed_out};
    } catch (const std::bad_alloc&) {
        result = {.status = ResultStatus::failed, .message = "out of memory"};
    } catch (const std::exception& error) {
        result = {.status = ResultStatus::failed, .message = error.what()};
    }
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
    result.seconds = seconds.count();
    return result;
}

}  // namespace waybreaker::experiment
