// The best obstacles to remove, with proof: docs/exact.md.
#pragma once

#include <vector>

#include "mission/candidate.hpp"
#include "waybreaker/crossing.hpp"

namespace waybreaker {

// A lower limit of the objective over all plans with at most options.removals obstacles removed, whatever the agent's
// radius: of a point, the air agent on its shortest way. `reached`: the objective of a plan; the limit is never above.
double bound_of(const Task& task, CrossingSearcher& crossing, double reached);

// The best draft there is for a set of at most options.removals obstacles, and what it had to beat on the way there.
// Sets come in the order of what their shortest path proves they cost at least; they end where that is no better than
// the best draft, or where time or patience does. Empty if nothing beats `nothing`. `bound`: of the objective.
std::vector<Draft> drafts_by_proof(const Task& task, CrossingSearcher& crossing, Searcher& searcher,
                                   const Draft& nothing, double bound);

// The shortest ground path of the planner the options name, on the map without some obstacles.
Candidate ground_candidate(const Task& task, CrossingSearcher& crossing, Searcher& searcher,
                           std::vector<ObstacleId> removed);

}  // namespace waybreaker
