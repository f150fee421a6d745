// The best obstacles to remove, with proof: docs/exact.md.
#pragma once

#include <optional>

#include "select/bound.hpp"
#include "select/opening_times.hpp"
#include "select/selector.hpp"

namespace waybreaker {

class ExactSelector : public Selector {
  public:
    explicit ExactSelector(const Searchers& searchers) : searchers_(searchers) {}
    Candidate baseline(const Task& task) override { return candidate_of(task, open(task.trip(), searchers_, {})); }
    // The best candidate there is, and what it had to beat on the way there; none if nothing beats `start`. Sets of
    // obstacles come in the order of what their shortest path proves they cost at least; they end where that is no
    // better than the best candidate, or where time or patience does. Where a limit comes before the first set, sets
    // that are likely to be good are tried with what is left of the call's time.
    Selected select(const Task& task, const Candidate& start) override;

  private:
    // What is known before sets are tried: a bound, what a quick search has found where there is little time or the
    // proof is long, and what the best plan reaches.
    struct Begun {
        Bound bound = {};
        Selected likely = {};
        std::optional<CrossingResult> square = {};  // of the search for the square's first set, if it was made
        double reached;
    };
    // `share_of_bound`: of the time that is left.
    Begun begin(const Task& task, const Candidate& start, double reached, double proven, const Deadline& deadline,
                double share_of_bound, OpeningTimes& opening_times);
    // `first`: what is known before.
    Selected select(const Task& task, const Candidate& start, Selected first, const Deadline& deadline,
                    OpeningTimes& opening_times);

    Searchers searchers_;
};

}  // namespace waybreaker
