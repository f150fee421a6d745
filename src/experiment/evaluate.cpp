#include "experiment/evaluate.hpp"

#include <chrono>
#include <new>

#include "waybreaker/error.hpp"

namespace waybreaker::experiment {
namespace {

MissionOptions mission_options(const Configuration& configuration, const std::stop_token& stop) {
    MissionOptions options;
    switch (configuration.method) {
        case Method::paper:
            options = paper_options(configuration.removals);
            break;
        case Method::none:
            options.select = configuration.planner == Planner::optimal ? Selection::exact : Selection::hits;
            options.timing = Timing::ignore;
            break;
        case Method::exact:
        case Method::greedy:
            break;
    }
    options.removals = configuration.removals;
    options.search.planner = configuration.planner;
    options.search.weight = configuration.weight;
    options.search.stop = stop;
    return options;
}

Stage stage_of(const Outcome& outcome) {
    return {.ground = outcome.ground.length,
            .expanded = outcome.ground.expanded,
            .generated = outcome.ground.generated,
            .seconds = outcome.ground.seconds,
            .air = outcome.air.length,
            .makespan = outcome.makespan,
            .flowtime = outcome.flowtime};
}

ResultStatus status_of(PlanStatus status) {
    switch (status) {
        case PlanStatus::solved:
            return ResultStatus::solved;
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
                       const std::stop_token& stop) {
    const Plan plan =
        planner_.plan(map, ground_and_air(mission.start, mission.goal), mission_options(configuration, stop));
    Result result{.status = status_of(plan.status),
                  .before = stage_of(plan.before),
                  .after = stage_of(plan.after),
                  .bound = plan.bound};
    for (const Removal& removal : plan.removed) result.removed.push_back(removal.obstacle);
    return result;
}

Result Evaluator::evaluate(const Map& map, const ExperimentMission& mission, const Configuration& configuration,
                           const std::stop_token& stop) {
    const auto begin = std::chrono::steady_clock::now();
    Result result;
    try {
        result = configuration.method == Method::greedy ? plan_greedily(map, mission, configuration.removals, stop)
                                                        : plan(map, mission, configuration, stop);
        // The exact method gives back the best it knew then; but a figure that hangs on the clock is none.
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
