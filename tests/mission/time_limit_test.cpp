// The time limit holds for the whole call, whatever the map and whatever is asked. Limits are generous: ten times and
// more what the call may take.
#include <gtest/gtest.h>

#include <array>
#include <random>
#include <string>

#include "core/stopwatch.hpp"
#include "waybreaker/check.hpp"
#include "waybreaker/planner.hpp"

namespace waybreaker {
namespace {

constexpr double limit = 0.5;
constexpr double far_too_long = 20 * limit;

// Single blocked cells, so many in a hundred; the corners are free.
Map scattered(int side, int percent) {
    Grid grid(side, side);
    std::mt19937 random(7);
    for (Cell c{0, 0}; c.y < side; ++c.y) {
        for (c.x = 0; c.x < side; ++c.x) grid.set_blocked(c, int(random() % 100) < percent);
    }
    for (const Cell c : {Cell{0, 0}, Cell{side - 1, side - 1}}) grid.set_blocked(c, false);
    return Map(std::move(grid));
}

Mission across(const Map& map, int removals, Objective objective = Objective::makespan) {
    Mission mission = ground_and_air({0, 0}, {map.width() - 1, map.height() - 1});
    mission.rules.removals = removals;
    mission.rules.objective = objective;
    return mission;
}

constexpr Method everything{.bound = true, .explain = true};

class WholeCall : public testing::TestWithParam<Objective> {};

TEST_P(WholeCall, EndsInTimeWithAPlanAndWhatIsProven) {
    const Map map = scattered(300, 30);
    const Mission mission = across(map, 5, GetParam());
    const Stopwatch watch;
    const Plan plan = Planner().plan(map, mission, everything, {.seconds = limit});
    EXPECT_LT(watch.seconds(), far_too_long);
    ASSERT_EQ(plan.status, PlanStatus::solved);
    EXPECT_TRUE(plan.limit_reached);
    EXPECT_LE(plan.bound.value(), value(plan.after, GetParam()).value());
    EXPECT_TRUE(check(map, mission, plan).empty());
}

TEST_P(WholeCall, InHasteIsTrueToo) {
    const Map map = scattered(100, 20);
    const Mission mission = across(map, 4, GetParam());
    const Plan best = Planner().plan(map, mission, {.bound = true}, {.seconds = far_too_long});
    const Plan plan = Planner().plan(map, mission, {.bound = true}, {.seconds = limit / 2});
    if (plan.status == PlanStatus::limit_reached) GTEST_SKIP() << "the machine was too busy to find any plan";
    ASSERT_EQ(plan.status, PlanStatus::solved);
    EXPECT_TRUE(check(map, mission, plan).empty());
    EXPECT_LE(plan.bound.value(), value(best.after, GetParam()).value());
    EXPECT_LE(best.bound.value(), value(plan.after, GetParam()).value());
    if (!plan.limit_reached) {
        EXPECT_NEAR(value(plan.after, GetParam()).value(), value(best.after, GetParam()).value(), 1e-6);
    }
}

std::string name_of(const testing::TestParamInfo<Objective>& objective) {
    constexpr std::array names{"Makespan", "Flowtime", "GroundMakespan"};
    return names.at(std::size_t(objective.param));
}

INSTANTIATE_TEST_SUITE_P(Objectives, WholeCall,
                         testing::Values(Objective::makespan, Objective::flowtime, Objective::ground_makespan),
                         name_of);

TEST(TimeLimit, HoldsForTheFront) {
    const Map map = scattered(300, 30);
    const Stopwatch watch;
    const std::vector<Plan> front = Planner().front(map, across(map, 5), everything, {.seconds = limit});
    EXPECT_LT(watch.seconds(), far_too_long);
    ASSERT_FALSE(front.empty());
    EXPECT_TRUE(front.back().limit_reached);
}

TEST(TimeLimit, HoldsForSchedulesOfManyRemovals) {
    const Map map = scattered(12, 45);
    Mission mission = across(map, 50);
    mission.rules.breach_time.per_obstacle = 1;
    const Stopwatch watch;
    Planner().plan(map, mission, everything, {.seconds = limit});
    EXPECT_LT(watch.seconds(), far_too_long);
}

TEST(TimeLimit, HoldsForAPointThatPassesBetweenCorners) {
    Grid grid(800, 800);
    for (Cell c{0, 0}; c.y < 800; ++c.y) {
        for (c.x = (c.y + 1) % 2; c.x < 800; c.x += 2) grid.set_blocked(c, true);
    }
    const Map checkerboard(std::move(grid));
    Mission mission = ground_and_air({0, 0}, {798, 400});
    mission.rules.removals = 5;
    mission.agents[0].body = point_body;
    const Stopwatch watch;
    Planner().plan(checkerboard, mission, everything, {.seconds = limit});
    EXPECT_LT(watch.seconds(), far_too_long);
}

TEST(TimeLimit, IsNotReachedWhereThereIsTime) {
    const Map map = scattered(30, 10);
    EXPECT_FALSE(Planner().plan(map, across(map, 1)).limit_reached);
}

}  // namespace
}  // namespace waybreaker
