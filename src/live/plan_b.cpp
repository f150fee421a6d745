// Plan B: what is left where a breach fails.
#include <algorithm>
#include <limits>

#include "waybreaker/revise.hpp"

namespace waybreaker {
namespace {

IfFailed if_failed(Planner& planner, const Map& map, const Mission& mission, const Plan& plan, const Breach& failed,
                   const Method& method, const Limits& limits) {
    State state;
    state.sequence = (plan.revised ? plan.revised->sequence : 0) + 1;
    state.now = failed.cleared_at;
    state.failed = {{failed.obstacle, failed.cleared_at}};
    const Revision left = revise(planner, map, mission, plan, state, 0, method, limits);
    if (left.plan.status != PlanStatus::solved) return {std::numeric_limits<double>::infinity()};
    IfFailed result{value(left.plan.after, mission.rules.objective).value_or(std::numeric_limits<double>::infinity())};
    const auto& by_others = mission.rules.opened;
    for (const TimedOpening& opened : left.mission.rules.opened) {
        if (std::ranges::find(by_others, opened.obstacle, &TimedOpening::obstacle) == by_others.end())
            result.removed.push_back(opened.obstacle);
    }
    for (const Breach& breach : left.plan.breaches) result.removed.push_back(breach.obstacle);
    return result;
}

}  // namespace

void add_if_failed(Planner& planner, const Map& map, const Mission& mission, Plan& plan, const Method& method,
                   const Limits& limits) {
    for (std::size_t i = 0; i < plan.breaches.size(); ++i)
        plan.breaches[i].if_failed = if_failed(planner, map, mission, plan, plan.breaches[i], method, limits);
}

}  // namespace waybreaker
