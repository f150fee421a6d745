// What each removal is worth.
#pragma once

#include "select/selector.hpp"
#include "waybreaker/plan.hpp"

namespace waybreaker {

// Fills in what the objective would lose without each removed obstacle (the best plan that must leave it alone), and
// which obstacle one removal more would take. What there is no time for stays empty.
void explain(const Task& task, const Searchers& searchers, Selector& selector, const Candidate& baseline,
             const Candidate& best, Plan& plan);

}  // namespace waybreaker
