#include "mission/explain.hpp"

#include <algorithm>

namespace waybreaker {
namespace {

double best_cost(const Task& task, Chooser& chooser, const Draft& nothing, const Rules& rules,
                 std::vector<ObstacleId>* removed = nullptr) {
    const Task other = task.under(rules);
    const Draft least = chooser.least(other, nothing);
    const std::vector<Draft> drafts = chooser.drafts(other, least);
    const Draft& best = best_of(other, least, drafts);
    if (removed != nullptr) *removed = best.candidate.removed;
    return cost(other, best);
}

}  // namespace

void explain(const Task& task, Chooser& chooser, const Draft& nothing, const Draft& best, Plan& plan) {
    const double reached = cost(task, best);
    for (Breach& breach : plan.breaches) {
        Rules without = task.rules;
        without.protect.push_back(breach.obstacle);
        std::erase(without.force, breach.obstacle);
        const double saves = best_cost(task, chooser, nothing, without) - reached;
        if (task.deadline.passed()) return;
        breach.saves = saves;
    }
    Rules more = task.rules;
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
