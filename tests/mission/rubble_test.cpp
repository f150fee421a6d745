// Rubble: what is removed takes longer to drive through.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "any_world.hpp"
#include "ascii_map.hpp"
#include "checked_plan.hpp"
#include "input_error.hpp"
#include "random_map.hpp"
#include "vehicle.hpp"
#include "waybreaker/advanced/crossing.hpp"
#include "waybreaker/check.hpp"
#include "waybreaker/planner.hpp"

namespace waybreaker {
namespace {

constexpr double never_arrives = std::numeric_limits<double>::infinity();

double objective_of(const Mission& mission, const Plan& plan) {
    return plan.status == PlanStatus::solved ? value(plan.after, mission.rules.objective).value() : never_arrives;
}

Mission without_rubble(Mission mission) {
    mission.rules.rubble = 0;
    return mission;
}

Mission removing_nothing(Mission mission) {
    mission.rules.removals = 0;
    mission.rules.force.clear();
    return mission;
}

// A pair, or one that breaches itself, as any_world() has them.
World any_pair_with_rubble() {
    World world = any_world();
    Agent& driver = world.mission.agents[0];
    driver.body.radius = *rc::gen::element(0.0, 0.3, 0.5, 0.5, 0.9);
    Rules& rules = world.mission.rules;
    rules.rubble = *rc::gen::element(0.5, 1.0, 2.5, 8.0);
    if (!world.map.obstacles().empty() && *number(0, 3) == 0) {
        rules.protect.clear();
        rules.opened = {{{1}, *rc::gen::element(0.0, 2.0, 9.0)}};
    }
    if (*number(0, 3) == 0) {
        driver.own_breaches = 2;
        world.mission.agents.pop_back();
    }
    return world;
}

World any_team_with_rubble() {
    World world = any_world();
    Rules& rules = world.mission.rules;
    const Cell goal = one_of(free_cells(world.map));
    Agent& second = world.mission.agents.emplace_back(vehicle("second", one_of(free_cells(world.map)), goal));
    second.speed = *rc::gen::element(0.5, 1.0);
    second.ready_at = *rc::gen::element(0.0, 3.0);
    for (Agent* agent : {&world.mission.agents[0], &second})
        agent->body.radius = *rc::gen::element(0.0, 0.3, 0.5, 0.5, 0.9);
    rules.rubble = *rc::gen::element(0.5, 1.0, 2.5, 8.0);
    rules.collisions = *rc::gen::arbitrary<bool>();
    rules.protect.clear();
    if (!world.map.obstacles().empty() && *number(0, 3) == 0) rules.opened = {{{1}, *rc::gen::element(0.0, 2.0, 9.0)}};
    return world;
}

Method any_selection() {
    Method method;
    method.select = *rc::gen::element(Selection::exact, Selection::exact, Selection::exact, Selection::greedy);
    method.bound = true;
    method.explain = *number(0, 2) == 0;
    return method;
}

void expect_laws(const World& world, const Method& method) {
    const auto& [map, mission] = world;
    const Plan plan = Planner().plan(map, mission, method);
    RC_CLASSIFY(plan.status == PlanStatus::solved && !plan.breaches.empty());
    const std::string faults = plan_faults(map, mission, plan);
    if (faults != "") RC_FAIL(faults);
    // What vehicles lose on each other is not proven.
    const bool pass_freely = !mission.is_team() || !mission.rules.collisions;
    const Plan closed = Planner().plan(map, removing_nothing(mission), method);
    if (pass_freely) RC_ASSERT(objective_of(mission, plan) <= objective_of(mission, closed) * (1 + 1e-9));
    const Plan cleared = Planner().plan(map, without_rubble(mission), method);
    if (cleared.bound) RC_ASSERT(objective_of(mission, plan) >= *cleared.bound * (1 - 1e-9));
    if (plan.bound && cleared.bound) RC_ASSERT(*plan.bound <= objective_of(mission, plan) * (1 + 1e-9));
}

RC_GTEST_PROP(Rubble, PlansOfPairsAreValidAndNoWorseThanToRemoveNothing, ()) {
    const World world = any_pair_with_rubble();
    RC_PRE(is_plannable(world));
    expect_laws(world, any_selection());
}

RC_GTEST_PROP(Rubble, PlansOfTeamsAreValidAndNoWorseThanToRemoveNothing, ()) {
    const World world = any_team_with_rubble();
    RC_PRE(is_plannable(world));
    Method method = any_selection();
    method.select = *rc::gen::element(Selection::exact, Selection::exact, Selection::greedy);
    expect_laws(world, method);
}

// The bound holds for the plans of every set that may be removed, planned by itself.
void expect_bound_below_all_sets(const World& world) {
    const auto& [map, mission] = world;
    RC_PRE(map.obstacles().size() <= 6U);
    const Plan plan = Planner().plan(map, mission);
    const auto is_opened = [&](ObstacleId id) {
        return std::ranges::count(mission.rules.opened, id, &TimedOpening::obstacle) > 0;
    };
    for (std::uint32_t set = 0; set < (1U << map.obstacles().size()); ++set) {
        if (std::popcount(set) > mission.removals_allowed()) continue;
        Mission forced = mission;
        for (std::uint32_t i = 0; i < map.obstacles().size(); ++i) {
            if ((set >> i & 1U) != 0) forced.rules.force.push_back({i + 1});
        }
        const bool may_be =
            std::ranges::none_of(forced.rules.force, is_opened) &&
            std::ranges::none_of(forced.rules.force, [&](ObstacleId id) {
                return std::ranges::count(mission.rules.protect, id) > 0 || !map.obstacle(id).destructible;
            });
        if (!may_be) continue;
        const Plan other = Planner().plan(map, forced);
        if (plan.bound) RC_ASSERT(*plan.bound <= objective_of(forced, other) * (1 + 1e-9));
    }
}

RC_GTEST_PROP(Rubble, BoundOfAPairHoldsForEverySet, ()) {
    World world = any_world();
    world.mission.agents[0].body.radius = *rc::gen::element(0.0, 0.5);
    world.mission.rules.rubble = *rc::gen::element(0.5, 1.0, 2.5);
    expect_bound_below_all_sets(world);
}

RC_GTEST_PROP(Rubble, BoundOfATeamHoldsForEverySet, ()) {
    World world = any_team_with_rubble();
    world.mission.rules.collisions = false;
    RC_PRE(is_plannable(world));
    expect_bound_below_all_sets(world);
}

// Where all is open from the start: by one search for each set that is driven through.
RC_GTEST_PROP(Rubble, OfAPointIsTheBestOfAllSets, ()) {
    const PlainMap plain = *random_map(9, 8);
    const Map map(plain.grid());
    RC_PRE(map.obstacles().size() <= 9U);
    const Cell start = any_free_cell(plain);
    Mission mission = ground_and_air(start, any_free_cell(plain));
    Agent& driver = mission.agents[0];
    driver.body = point_body;
    driver.speed = *rc::gen::element(0.5, 1.0);
    mission.agents[1].speed = 1000;
    mission.rules.removals = *number(0, 4);
    mission.rules.rubble = *rc::gen::element(0.25, 1.0, 3.0);
    mission.rules.objective = Objective::ground_makespan;
    CrossingSearcher searcher;
    double best = never_arrives;
    for (std::uint32_t set = 0; set < (1U << map.obstacles().size()); ++set) {
        if (std::popcount(set) > mission.rules.removals) continue;
        std::vector<ObstacleId> removed;
        for (std::uint32_t i = 0; i < map.obstacles().size(); ++i) {
            if ((set >> i & 1U) != 0) removed.push_back({i + 1});
        }
        const CrossingResult way =
            searcher.find(map, driver.start, driver.goal, {.body = driver.body, .removed = removed});
        if (way.status != SearchStatus::found) continue;
        best = std::min(best, way.best.length / driver.speed + double(removed.size()) * mission.rules.rubble);
    }
    const Plan plan = Planner().plan(map, mission);
    RC_ASSERT((plan.status == PlanStatus::solved) == std::isfinite(best));
    if (plan.status != PlanStatus::solved) return;
    RC_ASSERT(plan_faults(map, mission, plan) == "");
    RC_ASSERT(std::abs(*plan.after.ground_makespan - best) <= 1e-9 * (1 + best));
    RC_ASSERT(*plan.gap <= 1e-9);
}

Map walled() {
    return map_from_ascii(R"(
        .....#......
        .....#......
        .....#......
        .....#......
        .....#......
        ............
    )");
}

TEST(Rubble, IsDrivenThroughWhereThatIsQuicker) {
    const Map map = walled();
    Mission mission = ground_and_air({3, 0}, {7, 0});
    mission.rules.removals = 1;
    Planner planner;
    const double around = *planner.plan(map, removing_nothing(mission)).after.makespan;
    ASSERT_GT(around, 9);
    mission.rules.rubble = 4;
    const Plan through = planner.plan(map, mission);
    EXPECT_DOUBLE_EQ(*through.after.makespan, 8);
    ASSERT_EQ(through.breaches.size(), 1U);
    ASSERT_EQ(through.agents[0].waits.size(), 1U);
    EXPECT_EQ(through.agents[0].waits[0].reason, WaitReason::rubble);
    EXPECT_EQ(through.agents[0].waits[0].obstacle, through.breaches[0].obstacle);
    EXPECT_EQ(plan_faults(map, mission, through), "");
    mission.rules.rubble = 8.5;
    const Plan past = planner.plan(map, mission);
    EXPECT_DOUBLE_EQ(*past.after.makespan, around);
    EXPECT_TRUE(past.breaches.empty());
}

// Of two that must go the robot drives through the one that saves a long way.
TEST(Rubble, IsGoneAroundWhereThatIsShort) {
    const Map map = map_from_ascii(R"(
        .....#..#....
        .....#.......
        .....#.......
        .....#.......
        .....#.......
        .............
    )");
    Mission mission = ground_and_air({3, 0}, {11, 0});
    mission.rules.removals = 2;
    mission.rules.force = {{1}, {2}};
    mission.rules.rubble = 4;
    mission.rules.objective = Objective::ground_makespan;
    const Plan plan = Planner().plan(map, mission);
    EXPECT_EQ(plan_faults(map, mission, plan), "");
    EXPECT_EQ(plan.breaches.size(), 2U);
    EXPECT_LT(*plan.after.ground_makespan, 13.5);  // 16 through both, 14.1 around both
    EXPECT_EQ(std::ranges::count_if(plan.breaches, [](const Breach& breach) { return bool(breach.entered_at); }), 1);
}

// Two obstacles on a shorter way, one on a longer one: a search in time knows the rubble of one of them only.
TEST(Rubble, OfTwoMayBeWorthIt) {
    const std::vector<std::uint32_t> labels{1, 0, 0, 0, 2, 3, 2, 1, 3, 2, 2, 0};
    const Map map = Map::from_labels(3, 4, labels, std::vector<ObstacleAttributes>(4));
    Mission mission = ground_and_air({1, 0}, {2, 3});
    mission.agents[0].speed = 0.5;
    mission.agents[1].start = {0, 1};
    mission.agents[1].goal = {1, 1};
    mission.rules.removals = 2;
    mission.rules.rubble = 0.5;
    mission.rules.objective = Objective::ground_makespan;
    const Plan plan = Planner().plan(map, mission);
    EXPECT_EQ(plan.breaches.size(), 2U);
    EXPECT_NEAR(*plan.after.ground_makespan, 7.91421, 1e-5);
    EXPECT_EQ(plan_faults(map, mission, plan), "");
}

TEST(Rubble, OfTheCheckerIsThatOfTheRules) {
    const Map map = walled();
    Mission mission = ground_and_air({3, 0}, {7, 0});
    mission.rules.removals = 1;
    mission.rules.rubble = 4;
    const Plan plan = Planner().plan(map, mission);
    const auto rules_broken = [&](double rubble) {
        Mission other = mission;
        other.rules.rubble = rubble;
        std::vector<Rule> rules;
        for (const Violation& violation : check(map, other, plan)) rules.push_back(violation.rule);
        return rules;
    };
    EXPECT_TRUE(rules_broken(4).empty());
    EXPECT_EQ(rules_broken(4.5), (std::vector<Rule>{Rule::rubble, Rule::rubble}));
}

// Two turns at nearly one time: what is stood at each is for the obstacle behind it.
TEST(Rubble, OfTheFastestIsStoodTurnByTurn) {
    const Map map = map_from_ascii(R"(
        ..a..
        ####b
        ####.
    )");
    Mission mission = ground_and_air({0, 0}, {4, 2});
    mission.agents[0].speed = most_speed;
    mission.rules.protect = {map.obstacle_at({0, 1})};
    mission.rules.removals = 2;
    for (const double rubble : {20.0, 1000.0, 1e6}) {
        mission.rules.rubble = rubble;
        const Plan plan = Planner().plan(map, mission);
        EXPECT_EQ(plan.breaches.size(), 2U);
        EXPECT_EQ(plan_faults(map, mission, plan), "");
    }
}

// The wait for the opening does not count: the rubble comes after it.
TEST(Rubble, ComesAfterTheOpening) {
    const Map map = walled();
    Mission mission = ground_and_air({3, 0}, {7, 0});
    mission.rules.removals = 1;
    mission.rules.rubble = 2;
    mission.rules.breach_time.per_obstacle = 3;
    const Plan plan = Planner().plan(map, mission);
    EXPECT_EQ(plan_faults(map, mission, plan), "");
    ASSERT_EQ(plan.breaches.size(), 1U);
    EXPECT_GE(plan.breaches[0].entered_at.value(), plan.breaches[0].cleared_at + 2);
    Plan early = plan;
    Mission later = mission;
    later.rules.breach_time.per_obstacle = 3;
    for (Waypoint& point : early.agents[0].path) point.t = point.t > 0 ? point.t - 1 : 0;
    EXPECT_NE(plan_faults(map, later, early), "");
}

TEST(Rubble, IsRefusedWhereItMeansNothing) {
    const Map map = walled();
    Mission mission = ground_and_air({3, 0}, {7, 0});
    mission.rules.rubble = -1;
    EXPECT_EQ(input_error([&] { validate(map, mission); }),
              "the time that rubble takes must be from 0 to 1e+09, not -1");
    mission.rules.rubble = 1;
    mission.rules.timing = Timing::ignore;
    EXPECT_EQ(input_error([&] { validate(map, mission); }),
              "rubble takes time only where obstacles stand in time: leave it out, or let the timing be enforced");
}

}  // namespace
}  // namespace waybreaker
