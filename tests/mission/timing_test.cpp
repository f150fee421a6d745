// Missions in which obstacles stand until they are breached.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "ascii_map.hpp"
#include "checked_plan.hpp"
#include "random_map.hpp"
#include "waybreaker/planner.hpp"

namespace waybreaker {
namespace {

struct TimedMission {
    Map map;
    Mission mission;
    Method method;
    Limits limits;

    Plan plan() const {
        const Plan plan = Planner().plan(map, mission, method, limits);
        RC_ASSERT(plan_faults(map, mission, plan) == "");
        return plan;
    }
    // What the plan costs; infinity if there is none.
    double cost() const { return cost(plan().after); }
    double cost(const Outcome& outcome) const {
        return value(outcome, mission.rules.objective).value_or(std::numeric_limits<double>::infinity());
    }
};

TimedMission any_timed_mission() {
    const PlainMap plain = *random_map(24, 20);
    TimedMission world{Map(plain.grid()), ground_and_air(any_free_cell(plain), any_free_cell(plain)), {}, {}};
    if (*rc::gen::arbitrary<bool>()) world.mission.agents[1].start = any_cell(plain);
    if (*rc::gen::arbitrary<bool>()) world.mission.agents[1].goal = any_cell(plain);
    world.mission.agents[0].speed = *rc::gen::element(0.3, 1.0, 1.0, 3.0);
    world.mission.agents[1].speed = *rc::gen::element(0.5, 1.0, 1.0, 4.0);
    world.mission.agents[0].ready_at = *rc::gen::element(0.0, 0.0, 3.0, 15.0);
    world.method.select = Selection::hits;
    world.mission.rules.removals = *number(0, 4);
    world.method.flight = *rc::gen::element(FlightRule::optimal, FlightRule::nearest);
    world.mission.rules.objective =
        *rc::gen::element(Objective::makespan, Objective::flowtime, Objective::ground_makespan);
    world.mission.rules.breach_time = {*rc::gen::element(0.0, 0.0, 2.5), *rc::gen::element(0.0, 0.0, 0.2)};
    return world;
}

bool no_more(double a, double b) {
    return a <= b + 1e-6 || a == b;
}

// Not even in how much work it was.
RC_GTEST_PROP(Timing, APlannerPlansTheSameAgain, ()) {
    TimedMission world = any_timed_mission();
    world.method.select = *rc::gen::element(Selection::hits, Selection::exact, Selection::exact);
    world.limits.expansions = *rc::gen::element<std::uint64_t>(20, 200, UINT64_MAX, UINT64_MAX);
    Planner planner;
    const Plan first = planner.plan(world.map, world.mission, world.method, world.limits);
    const Plan again = planner.plan(world.map, world.mission, world.method, world.limits);
    RC_ASSERT(again.bound == first.bound);
    RC_ASSERT(again.agents.size() == first.agents.size());
    for (std::size_t i = 0; i < first.agents.size(); ++i) RC_ASSERT(again.agents[i].path == first.agents[i].path);
    RC_ASSERT(again.after.ground().expanded == first.after.ground().expanded);
    RC_ASSERT(again.after.ground().generated == first.after.ground().generated);
}

RC_GTEST_PROP(Timing, NeverMakesAPlanWorseThanToRemoveNothing, ()) {
    const TimedMission world = any_timed_mission();
    const Plan plan = world.plan();
    RC_ASSERT(no_more(world.cost(plan.after), world.cost(plan.before)));
}

// What is finer than a thousandth of a cell counts nowhere.
RC_GTEST_PROP(Timing, IsOfTheRadiusInThousandths, ()) {
    TimedMission fine = any_timed_mission();
    TimedMission coarse = fine;
    const int thousandths = *number(1, 1500);
    coarse.mission.agents[0].body.radius = thousandths / 1000.0;
    fine.mission.agents[0].body.radius = (thousandths + *number(-4, 4) / 10.0) / 1000.0;
    RC_PRE(fine.mission.agents[0].body.radius >= 0.001);
    const Agent& driver = coarse.mission.agents[0];
    const OpenedMap ground(coarse.map, {});
    RC_PRE(fits(ground, driver.start, driver.body) && fits(ground, driver.goal, driver.body));
    RC_ASSERT(fine.cost() == coarse.cost());
}

RC_GTEST_PROP(Timing, MoreRemovalsNeverCostMore, ()) {
    TimedMission world = any_timed_mission();
    const double few = world.cost();
    world.mission.rules.removals += *number(1, 5);
    RC_ASSERT(no_more(world.cost(), few));
}

RC_GTEST_PROP(Timing, OnlyWhatIsNeededIsRemoved, ()) {
    const TimedMission world = any_timed_mission();
    const Plan plan = world.plan();
    if (plan.status != PlanStatus::solved) return;
    for (const Breach& breach : plan.breaches) RC_ASSERT(breach.entered_at.has_value());
}

RC_GTEST_PROP(Timing, ALongerBreachOrASlowerFlightNeverHelps, ()) {
    TimedMission world = any_timed_mission();
    const double before = world.cost();
    if (*rc::gen::arbitrary<bool>()) {
        world.mission.rules.breach_time.per_obstacle += 1.5;
    } else {
        world.mission.agents[1].speed *= 0.7;
    }
    RC_ASSERT(no_more(before, world.cost()));
}

RC_GTEST_PROP(Timing, WhatIsProtectedOrTooDearStays, ()) {
    TimedMission world = any_timed_mission();
    world.mission.rules.removals = 4;
    world.mission.rules.protect = some_obstacles(world.map, 3);
    world.map = world.map.with_weights(std::vector<double>(world.map.obstacles().size() + 1, 1.5));
    world.mission.rules.budget = *rc::gen::element(1.0, 2.0, 3.0, 100.0);
    const Plan plan = world.plan();
    RC_ASSERT(double(plan.breaches.size()) * 1.5 <= world.mission.rules.budget);
    for (const Breach& breach : plan.breaches) {
        RC_ASSERT(std::ranges::count(world.mission.rules.protect, breach.obstacle) == 0);
    }
}

RC_GTEST_PROP(Timing, WhatMustGoGoes, ()) {
    TimedMission world = any_timed_mission();
    std::vector<ObstacleId> force = some_obstacles(world.map, 2);
    std::ranges::sort(force);
    force.erase(std::unique(force.begin(), force.end()), force.end());
    world.mission.rules.removals = std::max(world.mission.rules.removals, int(force.size()));
    world.mission.rules.force = force;
    const Plan plan = world.plan();
    for (const ObstacleId id : force) {
        RC_ASSERT(plan.agents.empty() || std::ranges::count(plan.breaches, id, &Breach::obstacle) == 1);
    }
}

constexpr std::string_view one_wall = R"(
    .............
    ......aa.....
    ......aa.....
    S.....aa....G
    ......aa.....
    ......aa.....
    .............)";

Plan plan_past_the_wall(double air_speed, double breach_time) {
    const Map map = map_from_ascii(one_wall);
    Mission mission = ground_and_air({0, 3}, {12, 3});
    mission.agents[1].speed = air_speed;
    mission.rules.breach_time.per_obstacle = breach_time;
    const Plan plan = Planner().plan(map, mission, {.select = Selection::hits});
    EXPECT_TRUE(is_valid(map, mission, plan));
    return plan;
}

TEST(Timing, NoWaitWhereTheAirAgentIsThereFirst) {
    const Plan plan = plan_past_the_wall(1, 0);
    EXPECT_DOUBLE_EQ(plan.after.makespan.value(), 12);
    EXPECT_EQ(plan.agents[0].path.size(), 2U);
}

TEST(Timing, AShortWaitIsBetterThanTheWayAround) {
    const Plan plan = plan_past_the_wall(1, 0.5);
    ASSERT_EQ(plan.breaches.size(), 1U);
    EXPECT_DOUBLE_EQ(plan.breaches[0].cleared_at, 5.5);
    EXPECT_DOUBLE_EQ(plan.breaches[0].entered_at.value(), 5.5);
    EXPECT_EQ(plan.agents[0].path, (std::vector<Waypoint>{{0, 3, 0}, {0, 3, 0.5}, {12, 3, 12.5}}));
    EXPECT_EQ(plan.agents[1].path, (std::vector<Waypoint>{{0, 3, 0}, {5, 3, 5}, {5, 3, 5.5}, {12, 3, 12.5}}));
}

TEST(Timing, TheWayAroundIsBetterThanALongWait) {
    const Plan plan = plan_past_the_wall(1, 5);
    EXPECT_TRUE(plan.breaches.empty());
    EXPECT_EQ(plan.after.ground().path, plan.before.ground().path);
    EXPECT_EQ(plan.after.makespan, plan.before.makespan);
}

TEST(Timing, AWallAcrossTheMapIsWaitedForHoweverLong) {
    const Map map = map_from_ascii(R"(
        ..a..
        ..a..
        ..a..)");
    Mission mission = ground_and_air({0, 1}, {4, 1});
    mission.rules.breach_time.per_cell = 30;
    const Plan plan = Planner().plan(map, mission, {.select = Selection::hits});
    EXPECT_TRUE(is_valid(map, mission, plan));
    EXPECT_DOUBLE_EQ(plan.after.makespan.value(), 1 + 90 + 3);
}

}  // namespace
}  // namespace waybreaker
