#include "select/greedy.hpp"

#include <utility>
#include <vector>

namespace waybreaker {

Candidate GreedySelector::baseline(const Task& task) {
    return around_late_openings(task, searchers_, candidate_of(task, open(task.trip(), searchers_, task.opened())));
}

std::vector<GreedyStep> greedy_steps(const Task& task, CrossingSearcher& crossing) {
    std::vector<GreedyStep> steps;
    std::vector<ObstacleId> removed = task.given;
    CrossingOptions options;
    options.body = task.driver.body;
    options.crossings = 1;
    options.protect = task.rules.protect;
    options.budget = task.spare_budget();
    for (int left = task.spare_removals(); left > 0 && !task.deadline.passed(); --left) {
        const Stopwatch watch;
        options.removed = removed;
        options.limits = limits_of(task, task.deadline.left());
        CrossingResult found = crossing.find(task.map, task.driver.start, task.driver.goal, options);
        if (found.best.crossed.empty()) break;
        const ObstacleId next = found.best.crossed.front();
        removed.push_back(next);
        options.budget -= task.map.obstacle(next).weight;
        steps.push_back({removed, std::move(found), watch.seconds()});
    }
    return steps;
}

Selected GreedySelector::select(const Task& task, const Candidate& /*start*/) {
    Selected selected;
    for (const GreedyStep& step : greedy_steps(task, searchers_.crossing)) {
        Opening opening = open(task.trip(), searchers_, step.removed, step.found, step.seconds);
        selected.candidates.push_back(
            around_late_openings(task, searchers_, candidate_of_needed(task, searchers_, std::move(opening))));
    }
    selected.limited = task.deadline.passed();
    return selected;
}

}  // namespace waybreaker
