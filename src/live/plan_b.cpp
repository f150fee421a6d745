// Plan B: what is left of a mission where a breach fails.
#include <algorithm>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "core/stopwatch.hpp"
#include "waybreaker/revise.hpp"

namespace waybreaker {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Reported when it was to be done, and nothing else.
State failure_of(const Breach& breach, const Plan& plan) {
    State state;
    state.sequence = (plan.revised ? plan.revised->sequence : 0) + 1;
    state.now = breach.cleared_at;
    state.failed = {{breach.obstacle, breach.cleared_at}};
    return state;
}

// Empty where it was not found out.
std::optional<IfFailed> outcome_of(const Mission& mission, const Revision& left) {
    if (left.status == RevisionStatus::broken || left.plan.status == PlanStatus::no_plan) return IfFailed{infinity};
    if (left.plan.status != PlanStatus::solved) return std::nullopt;
    IfFailed outcome{value(left.plan.after, mission.rules.objective).value_or(infinity)};
    // Those that had been breached before; what opens by itself is no removal.
    for (const TimedOpening& opened : left.mission.rules.opened) {
        if (std::ranges::find(mission.rules.opened, opened.obstacle, &TimedOpening::obstacle) ==
            mission.rules.opened.end())
            outcome.removed.push_back(opened.obstacle);
    }
    for (const Breach& breach : left.plan.breaches) outcome.removed.push_back(breach.obstacle);
    return outcome;
}

}  // namespace

Plan with_plan_b(Planner& planner, const Map& map, const Mission& mission, Plan plan, const Method& method,
                 const Limits& limits) {
    const Deadline deadline(limits.seconds);
    std::vector<std::optional<IfFailed>> outcomes;
    for (const Breach& breach : plan.breaches) {
        std::optional<IfFailed>& outcome = outcomes.emplace_back();
        if (deadline.passed()) continue;
        Limits left = limits;
        left.seconds = deadline.left();
        outcome = outcome_of(mission, revise(planner, map, mission, plan, failure_of(breach, plan), 0, method, left));
    }
    for (std::size_t i = 0; i < outcomes.size(); ++i) plan.breaches[i].if_failed = std::move(outcomes[i]);
    return plan;
}

}  // namespace waybreaker
