#include "mission/explain.hpp"

#include <algorithm>

namespace waybreaker {
namespace {

double best_cost(const Task& task, Chooser& chooser, const Draft& nothing, const MissionOptions& options,
                 std::vector<ObstacleId>* removed = nullptr) {
    const Draft least = chooser.least(options, nothing);
    const std::vector<Draft> drafts = chooser.drafts(options, least);
    const Draft& best = best_of(task, least, drafts);
    if (removed != nullptr) *removed = best.candidate.removed;
    return cost(task, best);
}

}  // namespace

void explain(const Task& task, Chooser& chooser, const Draft& nothing, const Draft& best, Plan& plan) {
    const double reached = cost(task, best);
    for (Removal& removal : plan.removed) {
        MissionOptions without = task.options;
        without.progress = {};
        without.protect.push_back(removal.obstacle);
        std::erase(without.force, removal.obstacle);
        const double saves = best_cost(task, chooser, nothing, without) - reached;
        if (task.deadline.passed()) return;
        removal.saves = saves;
    }
    MissionOptions more = task.options;
    more.progress = {};
    ++more.removals;
    std::vector<ObstacleId> removed;
    const double gain = reached - best_cost(task, chooser, nothing, more, &removed);
    if (gain <= 0 || task.deadline.passed()) return;
    for (const ObstacleId id : removed) {
        if (std::ranges::find(best.candidate.removed, id) != best.candidate.removed.end()) continue;
        plan.next.push_back({id, task.map.obstacle(id).source_id, gain});
        return;
    }
}

}  // namespace waybreaker
