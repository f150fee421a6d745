// The best obstacles to remove, with proof: docs/exact.md.
#pragma once

#include "select/selector.hpp"

namespace waybreaker {

class ExactSelector : public Selector {
  public:
    explicit ExactSelector(const Searchers& searchers) : searchers_(searchers) {}
    Candidate baseline(const Task& task) override {
        return around_late_openings(task, searchers_, candidate_of(task, open(task.trip(), searchers_, task.opened())));
    }
    // The best candidate there is, and what it had to beat on the way there; none if nothing beats `start`. Sets of
    // obstacles come in the order of what their shortest path proves they cost at least; they end where that is no
    // better than the best candidate, or where time or patience does. Where a limit comes before the first set, sets
    // that are likely to be good are tried with what is left of the call's time.
    Selected select(const Task& task, const Candidate& start) override;

  private:
    Searchers searchers_;
};

}  // namespace waybreaker
