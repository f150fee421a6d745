#include "coalition/own_mission.hpp"

#include <algorithm>
#include <utility>

#include "select/exact.hpp"
#include "select/task.hpp"

namespace waybreaker::coalition {
namespace {

Mission mission_of(const Problem& problem, std::size_t vehicle) {
    Mission mission;
    mission.agents.push_back(*problem.vehicles()[vehicle]);
    for (const Agent* agent : problem.aircraft()) mission.agents.push_back(*agent);
    mission.rules = problem.rules();
    mission.rules.removals = int(mission.rules.force.size()) + problem.spare_removals();
    return mission;
}

}  // namespace

OwnMission plan_own_mission(const Problem& problem, std::size_t vehicle, Worker& worker) {
    const Mission mission = mission_of(problem, vehicle);
    const Method method;
    Limits limits = problem.interrupts().limits();
    limits.gap = problem.interrupts().gap;
    const Task task = task_of(problem.map(), mission, method, limits);
    crossing::Memory memory;
    const Remembering remembering(worker.crossing, memory);
    const Searchers searchers{worker.theta, worker.crossing};
    ExactSelector selector(searchers);
    const Candidate start = start_of(task, searchers, selector.baseline(task));
    Selected selected = selector.select(task, start);
    OwnMission own;
    own.bound = selected.bound.value_or(0);
    for (Candidate& candidate : selected.candidates) {
        if (!candidate.opening.ground.length) continue;
        const double objective = cost(task, candidate);
        std::ranges::sort(candidate.opening.removed);
        own.proposals.push_back({std::move(candidate), objective});
    }
    std::ranges::stable_sort(own.proposals, {}, &OwnMission::Proposal::objective);
    return own;
}

}  // namespace waybreaker::coalition
