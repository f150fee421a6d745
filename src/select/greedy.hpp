// Greedy: again and again the one obstacle whose removal shortens the ground path most. Each step is proven by the
// crossing search, the whole is not: two obstacles may only gain together.
#pragma once

#include "select/selector.hpp"

namespace waybreaker {

// What must be removed and the first one, two, ... of those that greedy selection takes, and the search that found it.
struct GreedyStep {
    std::vector<ObstacleId> removed;
    CrossingResult found;
    double seconds;
};
// At most as many as the rules allow; fewer where no other gains or a limit comes first.
std::vector<GreedyStep> greedy_steps(const Task& task, CrossingSearcher& crossing);

// REQUIRES: the crossing search drives the ground agent.
class GreedySelector : public Selector {
  public:
    explicit GreedySelector(const Searchers& searchers) : searchers_(searchers) {}
    Candidate baseline(const Task& task) override;
    // A candidate for each step.
    Selected select(const Task& task, const Candidate& start) override;

  private:
    Searchers searchers_;
};

}  // namespace waybreaker
