// The best obstacles to remove, with proof: docs/exact.md.
#pragma once

#include <vector>

#include "core/stopwatch.hpp"
#include "mission/candidate.hpp"
#include "waybreaker/crossing.hpp"

namespace waybreaker {

// What is known of all plans with at most rules.removals obstacles removed.
struct Bound {
    double objective = 0;                  // no plan is below it, whatever the agent's radius
    std::vector<ObstacleId> removed = {};  // of the best way that the proof has found: worth a try
    bool limited = false;                  // a limit ended the proof
};

// The drafts that were looked at.
struct Choice {
    std::vector<Draft> drafts = {};
    bool limited = false;  // a limit ended the choice
};

// Of a point, the air agent on its shortest way. `reached`: the objective of a plan; the bound is never above. A proof
// that a limit ends is a bound as well.
Bound bound_of(const Task& task, CrossingSearcher& crossing, double reached, const Deadline& deadline);

// The best draft there is for a set of at most rules.removals obstacles, and what it had to beat on the way there;
// `least` is the draft without any but those that are removed in any case.
// Sets come in the order of what their shortest path proves they cost at least; they end where that is no better than
// the best draft, or where time or patience does. Where the deadline, or another limit, comes before the first set,
// sets that are likely to be good are tried with what is left of the call's time. Empty if nothing beats `least`.
Choice choice_by_proof(const Task& task, CrossingSearcher& crossing, Searcher& searcher, const Draft& least,
                       const Bound& bound, const Deadline& deadline);

// The shortest ground path of the planner the options name, on the map without some obstacles. Where the optimal one
// does not come in half the time that is left: Theta*'s.
Candidate ground_candidate(const Task& task, CrossingSearcher& crossing, Searcher& searcher,
                           std::vector<ObstacleId> removed);

}  // namespace waybreaker
