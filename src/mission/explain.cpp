#include "mission/explain.hpp"

#include <algorithm>

namespace waybreaker {
namespace {

// The best that the selection finds under other rules.
class OtherRules {
  public:
    OtherRules(const Task& task, const Searchers& searchers, Selector& selector, const Candidate& baseline)
        : task_(task), searchers_(searchers), selector_(selector), baseline_(baseline) {}

    double best_cost(const Rules& rules, std::vector<ObstacleId>* removed = nullptr) const {
        const Task other = task_.under(rules);
        const Candidate start = start_of(other, searchers_, baseline_);
        const Selected selected = selector_.select(other, start);
        const Candidate& best = best_of(other, start, selected.candidates);
        if (removed != nullptr) *removed = best.opening.removed;
        return cost(other, best);
    }

  private:
    const Task& task_;
    Searchers searchers_;
    Selector& selector_;
    const Candidate& baseline_;
};

}  // namespace

void explain(const Task& task, const Searchers& searchers, Selector& selector, const Candidate& baseline,
             const Candidate& best, Plan& plan) {
    const OtherRules under(task, searchers, selector, baseline);
    const double reached = cost(task, best);
    for (Breach& breach : plan.breaches) {
        Rules without = task.rules;
        without.protect.push_back(breach.obstacle);
        std::erase(without.force, breach.obstacle);
        const double saves = under.best_cost(without) - reached;
        if (task.deadline.passed()) return;
        breach.saves = saves;
    }
    Rules more = task.rules;
    ++more.removals;
    std::vector<ObstacleId> removed;
    const double gain = reached - under.best_cost(more, &removed);
    if (gain <= 0 || task.deadline.passed()) return;
    for (const ObstacleId id : removed) {
        if (std::ranges::find(best.opening.removed, id) != best.opening.removed.end()) continue;
        plan.next.push_back({id, task.map.obstacle(id).source_id, gain});
        return;
    }
}

}  // namespace waybreaker
