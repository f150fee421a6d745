// Greedy selection: each step as good as any one removal, every rule kept.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "ascii_map.hpp"
#include "checked_plan.hpp"
#include "input_error.hpp"
#include "random_map.hpp"
#include "waybreaker/advanced/crossing.hpp"

namespace waybreaker {
namespace {

constexpr Method greedy{.select = Selection::greedy};

RC_GTEST_PROP(Greedy, IsValidAndNeverBetterThanExact, ()) {
    const PlainMap plain = *random_map(20, 16);
    const Map map(plain.grid());
    Mission mission = ground_and_air(any_free_cell(plain), any_free_cell(plain));
    mission.rules.removals = *number(0, 3);
    mission.rules.protect = some_obstacles(map, 1);
    mission.rules.budget = *rc::gen::element(1.0, 2.0, 9.0);
    const Plan plan = Planner().plan(map, mission, greedy);
    RC_ASSERT(plan_faults(map, mission, plan) == "");
    RC_ASSERT(!plan.bound);
    if (!plan.after.ground().length) return;
    // No path that crosses so many is shorter.
    const CrossingResult shortest = CrossingSearcher().find(map, mission.agents[0].start, mission.agents[0].goal,
                                                            {.relaxed = true, .crossings = mission.rules.removals});
    RC_ASSERT(*plan.after.ground().length >= shortest.lower_bound * (1 - 1e-9));
}

// Two walls that only gain together: greedy sees nothing in the first step.
TEST(Greedy, SeesNoPairsThatGainTogether) {
    const Map map = map_from_ascii(R"(
        ....a.b....
        .wwwwwwwww.
        ...........)");
    Mission mission = ground_and_air({0, 0}, {10, 0});
    mission.rules = {.removals = 2, .protect = {map.obstacle_at({1, 1})}};
    EXPECT_TRUE(Planner().plan(map, mission, greedy).breaches.empty());
    EXPECT_EQ(Planner().plan(map, mission).breaches.size(), 2U);
}

TEST(Greedy, DrivesByTheOptimalPlanner) {
    const Map map{Grid(5, 5)};
    Mission mission = ground_and_air({0, 0}, {4, 4});
    mission.agents[0].body.corners = Corners::cut;
    EXPECT_NE(input_error([&] { validate(map, mission, greedy); }).find("greedy"), std::string::npos);
}

TEST(NoSelection, RemovesWhatMustBeAndNothingElse) {
    const Map map = map_from_ascii("..a..b..\n..a..b..");
    Mission mission = ground_and_air({0, 0}, {4, 0});
    const Method none{.select = Selection::none};
    EXPECT_EQ(Planner().plan(map, mission, none).status, PlanStatus::no_plan);
    mission.rules.force = {{1}};
    const Plan plan = Planner().plan(map, mission, none);
    EXPECT_TRUE(is_valid(map, mission, plan));
    ASSERT_EQ(plan.breaches.size(), 1U);
    EXPECT_EQ(plan.breaches[0].obstacle, ObstacleId{1});
}

}  // namespace
}  // namespace waybreaker
