#include "mission/team_demolition.hpp"

#include <cstdint>
#include <limits>
#include <utility>

#include "select/least_demolition.hpp"

namespace waybreaker {
namespace {

constexpr double share_of_plan = 0.5;  // of the time that is left

std::uint64_t cells_of(const Plan& plan) {
    std::uint64_t cells = 0;
    for (const Breach& breach : plan.breaches) cells += breach.cells;
    return cells;
}

}  // namespace

Plan demolish_least_as_team(const Map& map, const Mission& mission, const Deadline& deadline,
                            const TeamPlanner& planned, const Plan& best) {
    if (best.status != PlanStatus::solved) return best;
    const auto reached = [&](const Plan& plan) {
        return value(plan.after, mission.rules.objective).value_or(std::numeric_limits<double>::infinity());
    };
    const double limit = reached(best) * (1 + mission.rules.minimise_demolition.value_or(0)) * (1 + rounding);
    std::uint64_t forced = 0;
    for (const ObstacleId id : mission.rules.force) forced += map.obstacle(id).cells;
    const Map weighed = map.with_weights(cells_as_weights(map));
    Mission frugal = mission;
    Plan chosen = best;
    const auto within = [&](std::uint64_t cells) {
        frugal.rules.budget = double(cells);
        Plan plan = planned(weighed, frugal, deadline.left() * share_of_plan);
        if (!(reached(plan) <= limit)) {
            return WithinBudget{std::nullopt, plan.status == PlanStatus::no_plan || plan.bound.value_or(0) > limit};
        }
        const std::uint64_t demolished = cells_of(plan);
        if (demolished < cells_of(chosen)) chosen = std::move(plan);
        return WithinBudget{demolished};
    };
    const LeastCells found = least_cells(forced, cells_of(best), deadline, within);
    chosen.least_demolition = found.least;
    chosen.limit_reached = best.limit_reached || found.limited;
    chosen.bound = best.bound;
    if (chosen.bound) chosen.gap = *chosen.bound > 0 ? reached(chosen) / *chosen.bound - 1 : 0;
    return chosen;
}

}  // namespace waybreaker
