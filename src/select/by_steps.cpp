#include "select/by_steps.hpp"

#include <algorithm>
#include <utility>

#include "crossing/step_bound.hpp"
#include "select/candidate.hpp"
#include "select/tuning.hpp"

namespace waybreaker {
bool drives_by_steps(const Task& task, const OpeningTimes& opening_times) {
    return drives_by_crossing(task) && square_stands_for(task.driver.body) && !opening_times.matter();
}

bool has_time_for_steps(const Task& task, const OpeningTimes& opening_times) {
    const double cells = double(task.map.grid().cell_count()) * (task.spare_removals() + 1);
    // More expansions must not prove less, and whether steps are taken depends on what is known by then.
    const bool counts = task.limits.expansions < Limits{}.expansions;
    return !counts && cells <= task.limits.seconds * tuning::cells_stepped_per_second &&
           drives_by_steps(task, opening_times);
}

Bound prove_by_steps(const Task& task, double reached, double seconds, OpeningTimes& opening_times) {
    const CrossingOptions options = crossing_options(task, false, task.worth(reached), seconds, opening_times);
    StepBound steps = least_by_steps(task.map, task.driver.start, task.driver.goal, options);
    return {std::min(least_objective(task, steps.least, opening_times), reached), std::move(steps.crossed),
            steps.limited};
}

}  // namespace waybreaker
