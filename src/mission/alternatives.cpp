#include "mission/alternatives.hpp"

#include <algorithm>
#include <limits>

#include "mission/instead.hpp"

namespace waybreaker {
namespace {

bool remove_the_same(const Plan& a, const Plan& b) {
    return std::ranges::is_permutation(a.breaches, b.breaches, {}, &Breach::obstacle, &Breach::obstacle);
}

}  // namespace

void append_alternatives(const Evaluated& evaluated, Objective objective, std::vector<Plan>& plans) {
    const auto reached = [objective](const Plan& plan) {
        if (plan.status != PlanStatus::solved) return std::numeric_limits<double>::infinity();
        return value(plan.after, objective).value_or(std::numeric_limits<double>::infinity());
    };
    const double most = reached(plans.front()) * (1 + evaluated.share);
    if (plans.front().status != PlanStatus::solved) return;
    std::vector<const Plan*> good;
    for (const Plan& plan : evaluated.plans) {
        if (reached(plan) <= most) good.push_back(&plan);
    }
    std::ranges::stable_sort(good, {}, [&](const Plan* plan) { return reached(*plan); });
    for (const Plan* plan : good) {
        const auto is_same = [plan](const Plan& other) { return remove_the_same(*plan, other); };
        if (std::ranges::any_of(plans, is_same)) continue;
        Plan other = instead(plans.front(), *plan, objective);
        other.before = plans.front().before;
        plans.push_back(std::move(other));
    }
}

}  // namespace waybreaker
