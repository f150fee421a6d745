// Discs that the unit square does not stand for: what they pass, and that nothing goes that they do without.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <limits>

#include "ascii_map.hpp"
#include "checked_plan.hpp"
#include "random_map.hpp"
#include "waybreaker/planner.hpp"

namespace waybreaker {
namespace {

Mission mission_of_disc(double radius, Cell start, Cell goal, int removals) {
    Mission mission = ground_and_air(start, goal);
    mission.agents[0].body.radius = radius;
    mission.rules.removals = removals;
    return mission;
}

bool fits_there(const Map& map, const Mission& mission) {
    const Agent& driver = mission.agents[0];
    return fits(OpenedMap(map), driver.start, driver.body) && fits(OpenedMap(map), driver.goal, driver.body);
}

TEST(Disc, PassesBetweenRowsOfCells) {
    const Map door = map_from_ascii(R"(
        ....
        ....
        ....
        ....
        #..#
        ....
        ....
        ....
        ....)");
    for (const int removals : {0, 3}) {
        Mission mission = mission_of_disc(0.8, {1, 1}, {2, 7}, removals);
        mission.rules.breach_time.per_obstacle = 30;
        const Plan plan = Planner().plan(door, mission);
        ASSERT_TRUE(is_valid(door, mission, plan));
        EXPECT_TRUE(plan.breaches.empty());
        EXPECT_DOUBLE_EQ(*plan.after.makespan, distance(Cell{1, 1}, Cell{2, 7}));
        EXPECT_EQ(plan.before.makespan, plan.after.makespan);
    }
}

TEST(Disc, BendsWhereItsSquareDoesNotFit) {
    const Map map = map_from_ascii(R"(
        .....
        aa...
        .....
        ....b
        ....b)");
    for (const int removals : {0, 2}) {
        Mission mission = mission_of_disc(1, {1, 3}, {3, 1}, removals);
        mission.rules.breach_time.per_obstacle = 50;
        const Plan plan = Planner().plan(map, mission);
        ASSERT_TRUE(is_valid(map, mission, plan));
        EXPECT_TRUE(plan.breaches.empty());
        EXPECT_DOUBLE_EQ(*plan.after.makespan, 1 + distance(Cell{2, 3}, Cell{3, 1}));
    }
}

TEST(Disc, TakesNoDetourBecauseItsSquareDoes) {
    const Map map = map_from_ascii(R"(
        .......
        .......
        .......
        ...a...
        .......
        .......
        ....b..)");
    const Mission mission = mission_of_disc(0.7, {5, 3}, {3, 5}, 0);
    const Plan plan = Planner().plan(map, mission);
    ASSERT_TRUE(is_valid(map, mission, plan));
    EXPECT_DOUBLE_EQ(*plan.after.makespan, distance(Cell{5, 3}, Cell{3, 5}));
}

TEST(Disc, TakesAnotherWayThanThePointSlipsThrough) {
    const Map map = map_from_ascii(R"(
        ##.................
        ...................
        ...................
        ...................
        #####..............
        ...###.............
        ...................
        ...................
        ...................
        ...................
        ................###)");
    const Mission mission = mission_of_disc(0.7, {6, 1}, {2, 6}, 0);
    const Plan plan = Planner().plan(map, mission);
    ASSERT_TRUE(is_valid(map, mission, plan));
    const Plan theta = Planner().plan(map, mission, {.planner = Algorithm::theta});
    EXPECT_LE(*plan.after.makespan, *theta.after.makespan * (1 + 1e-9));
}

TEST(Disc, GoesWhereForcingASetShowsAWay) {
    const Map map = map_from_ascii(R"(
        ........
        ..a....a
        ...b..bc
        .....b..
        b..d....
        ....dc..)");
    Mission mission = mission_of_disc(0.7, {4, 1}, {1, 2}, 1);
    const Plan chosen = Planner().plan(map, mission);
    ASSERT_TRUE(is_valid(map, mission, chosen));
    mission.rules.force = {map.obstacle_at({3, 2})};
    EXPECT_LE(*chosen.after.makespan, *Planner().plan(map, mission).after.makespan * (1 + 1e-9));
}

// Theta* drives to a wall that is opened too late, and past it.
TEST(Disc, LeavesWhatItDoesNotEnter) {
    const Map map = map_from_ascii("...a.\n...b.");
    Mission mission = mission_of_disc(0.5, {1, 1}, {4, 1}, 3);
    mission.agents[1].goal = {1, 1};
    mission.rules.breach_time.per_obstacle = 8;
    mission.rules.objective = Objective::ground_makespan;
    const Plan plan = Planner().plan(map, mission, {.planner = Algorithm::theta});
    ASSERT_TRUE(is_valid(map, mission, plan));
    ASSERT_EQ(plan.breaches.size(), 1U);
    EXPECT_EQ(plan.breaches[0].obstacle, map.obstacle_at({3, 1}));
}

RC_GTEST_PROP(Disc, EntersAllThatGoes, ()) {
    const PlainMap plain = *random_map(10, 8);
    const Map map(plain.grid());
    const double radius = *rc::gen::element(0.2, 0.5, 0.6, 0.7, 1.0, 1.5);
    Mission mission = mission_of_disc(radius, any_free_cell(plain), any_free_cell(plain), *number(0, 3));
    mission.rules.breach_time.per_obstacle = *rc::gen::element(0.0, 2.0, 20.0);
    RC_PRE(fits_there(map, mission));
    const Algorithm planner = *rc::gen::element(Algorithm::optimal, Algorithm::theta);
    const Plan plan = Planner().plan(map, mission, {.planner = planner});
    RC_ASSERT(plan_faults(map, mission, plan) == "");
    if (plan.status != PlanStatus::solved) return;
    RC_ASSERT(std::ranges::all_of(plan.breaches, [](const Breach& breach) { return breach.entered_at.has_value(); }));
    if (!plan.before.makespan) return;
    RC_ASSERT(*plan.after.makespan <= *plan.before.makespan * (1 + 1e-9));
}

// Single blocked cells, so few that a wide disc passes between some of them.
PlainMap sparse_map() {
    PlainMap map{*number(16, 28), *number(16, 28), {}};
    map.obstacles.resize(std::size_t(map.width * map.height));
    const int stones = *number(6, 24);
    for (int i = 0; i < stones; ++i) map.obstacles[map.index(any_cell(map))] = 1;
    return map;
}

// "Before" is the mission without removals, the same for any number of them; shorter only where the way past other
// obstacles turns out to need no removal. No plan is worse than that, nor, by more
// than a hundredth, than what greedy selection gives, or Theta* past the obstacles that it hits most.
RC_GTEST_PROP(Disc, IsNoWorseThanWhatSimplerWaysToSelectFind, ()) {
    const PlainMap plain = sparse_map();
    const Map map(plain.grid());
    const double radius = *rc::gen::element(0.2, 0.5, 0.6, 0.75, 1.0, 1.5, 2.0);
    Mission mission = mission_of_disc(radius, any_free_cell(plain), any_free_cell(plain), 0);
    RC_PRE(fits_there(map, mission));
    const auto makespan = [](const Plan& plan) {
        return plan.after.makespan.value_or(std::numeric_limits<double>::infinity());
    };
    Planner planner;
    const Plan closed = planner.plan(map, mission);
    mission.rules.removals = *number(1, 2);
    const Plan plan = planner.plan(map, mission);
    RC_ASSERT(plan_faults(map, mission, plan) == "");
    if (!plan.breaches.empty()) RC_ASSERT(plan.before.makespan == closed.after.makespan);
    RC_ASSERT(makespan(plan) <= makespan(closed) * (1 + 1e-9));
    for (const Method& method :
         {Method{.select = Selection::greedy}, Method{.select = Selection::hits, .planner = Algorithm::theta}}) {
        const double other = makespan(planner.plan(map, mission, method));
        RC_LOG() << "reached " << makespan(plan) << ", another way " << other << '\n';
        RC_ASSERT(makespan(plan) <= other * 1.01);
    }
}

// What a planner remembers of a map holds for the same map with other weights, to and fro.
RC_GTEST_PROP(Disc, AUsedPlannerPlansAReweightedMapAsAFreshOneDoes, ()) {
    const PlainMap plain = *random_map(14, 10);
    const Map map(plain.grid());
    std::vector<double> weights{0};
    for (std::size_t i = 0; i < map.obstacles().size(); ++i) weights.push_back(*rc::gen::element(0.5, 1.0, 3.0));
    const Map heavy = map.with_weights(weights);
    const double radius = *rc::gen::element(0.2, 0.5, 0.6, 0.7, 1.0, 1.5);
    Mission mission = mission_of_disc(radius, any_free_cell(plain), any_free_cell(plain), 3);
    RC_PRE(fits_there(map, mission));
    mission.rules.budget = *rc::gen::element(1.0, 2.0, 4.0);
    Planner used;
    for (const Map* weighed : {&map, &heavy, &map}) {
        const Plan plan = used.plan(*weighed, mission);
        const Plan fresh = Planner().plan(*weighed, mission);
        RC_ASSERT(plan_faults(*weighed, mission, plan) == "");
        RC_ASSERT(plan.status == fresh.status);
        RC_ASSERT(plan.bound == fresh.bound);
        RC_ASSERT(plan.agents.size() == fresh.agents.size());
        for (std::size_t i = 0; i < plan.agents.size(); ++i) RC_ASSERT(plan.agents[i].path == fresh.agents[i].path);
    }
}

TEST(Disc, KeepsToTheBudgetOfTheMapAtHand) {
    const Map map = map_from_ascii("....a....\n....a....\n....a....\n....a....\n....a....");
    const Map heavy = map.with_weights(std::vector<double>{0, 5});
    Mission mission = mission_of_disc(0.7, {1, 2}, {7, 2}, 1);
    mission.rules.budget = 2;
    Planner planner;
    EXPECT_EQ(planner.plan(map, mission).status, PlanStatus::solved);
    EXPECT_EQ(planner.plan(heavy, mission).status, PlanStatus::no_plan);
    EXPECT_EQ(planner.plan(map, mission).status, PlanStatus::solved);
}

// Theta* is asked where a plan ends more than 1 % above its bound.
RC_GTEST_PROP(Disc, DrivesNoLongerThanThetaByMoreThanAHundredth, ()) {
    const PlainMap plain = *random_map(24, 20);
    const Map map(plain.grid());
    const double radius = *rc::gen::element(0.2, 0.6, 0.7, 1.0, 1.5);
    const Mission mission = mission_of_disc(radius, any_free_cell(plain), any_free_cell(plain), 0);
    RC_PRE(fits_there(map, mission));
    const Plan theta = Planner().plan(map, mission, {.planner = Algorithm::theta});
    if (theta.status != PlanStatus::solved) return;
    const Plan plan = Planner().plan(map, mission);
    RC_ASSERT(plan.status == PlanStatus::solved);
    RC_CLASSIFY(*plan.after.makespan < *theta.after.makespan * (1 - 1e-9), "shorter");
    RC_ASSERT(*plan.after.makespan <= *theta.after.makespan * 1.01);
}

}  // namespace
}  // namespace waybreaker
