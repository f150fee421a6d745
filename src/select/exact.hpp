// The best obstacles to remove, with proof: docs/exact.md.
#pragma once

#include <vector>

#include "select/opening_times.hpp"
#include "select/selector.hpp"

namespace waybreaker {

// What is known of all plans that keep to the rules.
struct Bound {
    double objective = 0;                  // no plan is below it, whatever the agent's radius
    std::vector<ObstacleId> removed = {};  // of the best way that the proof has found: worth a try
    bool limited = false;                  // a limit ended the proof
};

// Of a point, the air agent on its shortest way. `reached`: the objective of a plan; the bound is never above. A proof
// that a limit ends is a bound as well.
Bound prove_bound(const Task& task, CrossingSearcher& crossing, double reached, const Deadline& deadline);
Bound prove_bound(const Task& task, CrossingSearcher& crossing, double reached, const Deadline& deadline,
                  OpeningTimes& opening_times);

class ExactSelector : public Selector {
  public:
    explicit ExactSelector(const Searchers& searchers) : searchers_(searchers) {}
    Candidate baseline(const Task& task) override { return candidate_of(task, open(task, searchers_, {})); }
    // The best candidate there is, and what it had to beat on the way there; none if nothing beats `start`. Sets of
    // obstacles come in the order of what their shortest path proves they cost at least; they end where that is no
    // better than the best candidate, or where time or patience does. Where a limit comes before the first set, sets
    // that are likely to be good are tried with what is left of the call's time.
    Selected select(const Task& task, const Candidate& start) override;

  private:
    // `reached`: by a plan that is known; `proven`: no plan is below.
    Selected select(const Task& task, const Candidate& start, double reached, double proven, const Deadline& deadline,
                    OpeningTimes& opening_times);

    Searchers searchers_;
};

}  // namespace waybreaker
