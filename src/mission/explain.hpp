// What each removal is worth.
#pragma once

#include "mission/chooser.hpp"
#include "waybreaker/plan.hpp"

namespace waybreaker {

// Fills in what the objective would lose without each removed obstacle (the best plan that must leave it alone), and
// which obstacle one removal more would take. What there is no time for stays empty.
void explain(const Task& task, Chooser& chooser, const Draft& nothing, const Draft& best, Plan& plan);

}  // namespace waybreaker
