#include "select/greedy.hpp"

namespace waybreaker {

Candidate GreedySelector::baseline(const Task& task) {
    return candidate_of(task, open(task.trip(), searchers_, {}));
}

Selected GreedySelector::select(const Task& task, const Candidate& /*start*/) {
    const Stopwatch watch;
    Selected selected;
    std::vector<ObstacleId> removed = task.rules.force;
    CrossingOptions options;
    options.body = task.driver.body;
    options.crossings = 1;
    options.protect = task.rules.protect;
    options.budget = task.spare_budget();
    for (int left = task.spare_removals(); left > 0 && !task.deadline.passed(); --left) {
        options.removed = removed;
        options.limits = limits_of(task, task.deadline.left());
        const CrossingResult found = searchers_.crossing.find(task.map, task.driver.start, task.driver.goal, options);
        if (found.best.crossed.empty()) break;
        const ObstacleId next = found.best.crossed.front();
        removed.push_back(next);
        options.budget -= task.map.obstacle(next).weight;
        selected.candidates.push_back(candidate_of(task, opening_of(task.trip(), removed, found, watch.seconds())));
    }
    selected.limited = task.deadline.passed();
    return selected;
}

}  // namespace waybreaker
