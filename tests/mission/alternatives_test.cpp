// Alternatives: plans that were evaluated on the way to one, and are nearly as good.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "ascii_map.hpp"
#include "checked_plan.hpp"
#include "input_error.hpp"
#include "random_map.hpp"
#include "vehicle.hpp"
#include "waybreaker/planner.hpp"

namespace waybreaker {
namespace {

Mission any_mission(const PlainMap& plain) {
    Mission mission{{vehicle("rover", any_free_cell(plain), any_free_cell(plain))}};
    const int aircraft_count = *number(1, 2);
    for (int i = 0; i < aircraft_count; ++i) {
        mission.agents.push_back(
            aircraft("heli" + std::to_string(i), any_cell(plain), any_cell(plain), *rc::gen::element(0.5, 1.0, 4.0)));
    }
    mission.agents.back().breaches = *number(0, 2);
    Rules& rules = mission.rules;
    rules.removals = *number(1, 3);
    rules.objective = *rc::gen::element(Objective::makespan, Objective::flowtime, Objective::ground_makespan);
    rules.breach_time.per_obstacle = *rc::gen::element(0.0, 2.5, 8.0);
    const int opened = *number(0, 2);
    for (int i = 1; i <= opened; ++i) rules.opened.push_back({{std::uint32_t(i)}, 4.0 * i});
    return mission;
}

double reached(const Plan& plan, const Mission& mission) {
    return *value(plan.after, mission.rules.objective);
}

RC_GTEST_PROP(Alternatives, BeginWithThePlanAndStayWithinTheShare, ()) {
    const PlainMap plain = *random_map(12, 12);
    const Map map(plain.grid());
    const Mission mission = any_mission(plain);
    RC_PRE(map.obstacles().size() >= mission.rules.opened.size());
    const double share = *rc::gen::element(0.0, 0.1, 1.0, 1.0);
    Planner planner;
    const Plan plan = planner.plan(map, mission);
    const std::vector<Plan> plans = planner.alternatives(map, mission, share);
    RC_ASSERT(plans.front().status == plan.status);
    if (plan.status != PlanStatus::solved) {
        RC_ASSERT(plans.size() == 1U);
        return;
    }
    RC_CLASSIFY(plans.size() > 1);
    for (std::size_t i = 0; i < plan.agents.size(); ++i) RC_ASSERT(plans.front().agents[i].path == plan.agents[i].path);
    for (std::size_t i = 0; i < plans.size(); ++i) {
        RC_ASSERT(plan_faults(map, mission, plans[i]) == "");
        RC_ASSERT(reached(plans[i], mission) <= reached(plan, mission) * (1 + share) * (1 + 1e-12));
        for (std::size_t j = 0; j < i; ++j) {
            RC_ASSERT(!std::ranges::is_permutation(plans[i].breaches, plans[j].breaches, {}, &Breach::obstacle,
                                                   &Breach::obstacle));
        }
    }
}

TEST(Alternatives, AreWhatRemovesNothingAsWell) {
    const Map map = Map::from_rows({
        ".........",
        "....A....",
        "....A....",
    });
    const Mission mission = ground_and_air({0, 2}, {8, 2});
    Planner planner;
    EXPECT_EQ(planner.alternatives(map, mission, 0).size(), 1U);
    const std::vector<Plan> plans = planner.alternatives(map, mission, 0.5);
    ASSERT_EQ(plans.size(), 2U);
    EXPECT_EQ(plans[0].breaches.size(), 1U);
    EXPECT_EQ(plans[1].breaches.size(), 0U);
    EXPECT_EQ(plans[1].after.makespan, plans[0].before.makespan);
    EXPECT_EQ(plans[1].bound, plans[0].bound);
    EXPECT_EQ(input_error([&] { static_cast<void>(planner.alternatives(map, mission, -1)); }),
              "the share by which alternatives may be worse must be from 0 to 1, not -1");
}

}  // namespace
}  // namespace waybreaker
