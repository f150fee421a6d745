// By steps: where sets are countless, steps from cell to cell tell what no plan is below, and a set that is likely to
// be good: docs/exact.md, Theorem 5.
#pragma once

#include "select/bound.hpp"
#include "select/opening_times.hpp"
#include "select/task.hpp"

namespace waybreaker {

// Whether the driver's path goes by steps that the unit square could take as well, and obstacles open at once.
bool drives_by_steps(const Task& task, const OpeningTimes& opening_times);

// Whether the call has time for that, too: by its limit, not by what is left, so that plans repeat.
bool has_time_for_steps(const Task& task, const OpeningTimes& opening_times);

// REQUIRES: drives_by_steps. `reached`: the objective of a plan; the bound is never above.
Bound prove_by_steps(const Task& task, double reached, double seconds, OpeningTimes& opening_times);

}  // namespace waybreaker
