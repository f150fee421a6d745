// Greedy: again and again the one obstacle whose removal shortens the ground path most. Each step is proven by the
// crossing search, the whole is not: two obstacles may only gain together.
#pragma once

#include "select/selector.hpp"

namespace waybreaker {

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
