// What each removal is worth.
#pragma once

#include <functional>

#include "core/stopwatch.hpp"
#include "select/selector.hpp"
#include "waybreaker/plan.hpp"

namespace waybreaker {

// Fills in what the objective would lose without each removed obstacle (the best plan that must leave it alone), and
// which obstacle one removal more would take. What there is no time for stays empty.
void explain(const Task& task, const Searchers& searchers, Selector& selector, const Candidate& baseline,
             const Candidate& best, Plan& plan);

// The same for a team, and what each ground agent gains: `planned` plans it under other rules, within the limits in the
// time that is left until the deadline.
void explain_team(const Map& map, const Mission& mission, const Limits& limits, const Deadline& deadline,
                  const std::function<Plan(const Mission&, const Limits&)>& planned, Plan& plan);

// Fills in what each ground agent gains. REQUIRES: the plan is solved, and its agents are the mission's.
void explain_agents(const Mission& mission, Plan& plan);

}  // namespace waybreaker
