// Alternatives: plans that were evaluated on the way to one, and are nearly as good.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "ascii_map.hpp"
#include "checked_plan.hpp"
#include "coalition/any_coalition.hpp"
#include "input_error.hpp"
#include "random_map.hpp"
#include "team/simulation.hpp"
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

bool remove_the_same(const Plan& a, const Plan& b) {
    return std::ranges::is_permutation(a.breaches, b.breaches, {}, &Breach::obstacle, &Breach::obstacle);
}

// The plan is what it is without them, and each of the others is a plan, near enough, of a set of its own.
void judge_alternatives(const Map& map, const Mission& mission, const Method& method = {}) {
    const double share = *rc::gen::element(0.0, 0.1, 1.0, 1.0);
    const Plan plan = Planner().plan(map, mission, method);
    const std::vector<Plan> plans = Planner().alternatives(map, mission, share, method);
    RC_ASSERT(plans.front().status == plan.status);
    if (plan.status != PlanStatus::solved) {
        RC_ASSERT(plans.size() == 1U);
        return;
    }
    RC_CLASSIFY(plans.size() > 1, "others");
    RC_CLASSIFY(plans.size() > 2, "several others");
    RC_ASSERT(plans.front().bound == plan.bound);
    RC_ASSERT(remove_the_same(plans.front(), plan));
    for (std::size_t i = 0; i < plan.agents.size(); ++i) RC_ASSERT(plans.front().agents[i].path == plan.agents[i].path);
    for (std::size_t i = 0; i < plans.size(); ++i) {
        RC_ASSERT(plan_faults(map, mission, plans[i]) == "");
        RC_ASSERT(reached(plans[i], mission) <= reached(plan, mission) * (1 + share) * (1 + 1e-12));
        if (i > 1) RC_ASSERT(reached(plans[i], mission) >= reached(plans[i - 1], mission) * (1 - 1e-12));
        if (plan.bound) RC_ASSERT(*plans[i].bound <= reached(plans[i], mission));
        for (std::size_t j = 0; j < i; ++j) RC_ASSERT(!remove_the_same(plans[i], plans[j]));
    }
}

RC_GTEST_PROP(Alternatives, BeginWithThePlanAndStayWithinTheShare, ()) {
    const PlainMap plain = *random_map(12, 12);
    const Map map(plain.grid());
    const Mission mission = any_mission(plain);
    RC_PRE(map.obstacles().size() >= mission.rules.opened.size());
    judge_alternatives(map, mission);
}

RC_GTEST_PROP(Alternatives, AreOfTeamsAsWell, ()) {
    const PlainMap plain = *random_map(16, 16);
    const Map map(plain.grid());
    Mission mission = any_coalition(plain, map);
    Rules& rules = mission.rules;
    rules.force.clear();
    for (const ObstacleId id : some_obstacles(map, 1)) rules.opened.push_back({id, *rc::gen::element(0.0, 4.0, 30.0)});
    const bool takes_time = rules.breach_time.per_obstacle + rules.breach_time.per_cell > 0;
    RC_TAG(takes_time ? "breaches take time" : "breaches take no time");
    Method method;
    method.select = *rc::gen::element(Selection::exact, Selection::exact, Selection::hits);
    judge_alternatives(map, mission, method);
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

TEST(Alternatives, OfATeamArePlannedPastEachOther) {
    const Map map = Map::from_rows({
        "..........",
        "....#A#...",
        "....#A#...",
        "....#A#...",
        "....#.#...",
        "..........",
    });
    // One vehicle comes the other way, and there is no room for both beside the wall.
    Mission mission{{vehicle("east", {0, 5}, {9, 5}, 0.5), vehicle("west", {9, 4}, {0, 4}, 0.5),
                     aircraft("heli", {5, 0}, {5, 0}, 4)}};
    mission.rules.breach_time.per_obstacle = 2;
    const std::vector<Plan> plans = Planner().alternatives(map, mission, 1);
    ASSERT_EQ(plans.size(), 2U);
    EXPECT_NE(plans[0].breaches.size(), plans[1].breaches.size());
    for (const Plan& plan : plans) {
        EXPECT_TRUE(is_valid(map, mission, plan));
        EXPECT_EQ(simulate(map, mission, plan, 0.01), "");
        ASSERT_TRUE(plan.bound && plan.gap);
        EXPECT_NEAR(*plan.bound * (1 + *plan.gap), *plan.after.makespan, 1e-9);
    }
    EXPECT_EQ(plans[1].before.makespan, plans[0].before.makespan);
}

}  // namespace
}  // namespace waybreaker
