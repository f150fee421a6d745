// Every plan that the planner makes passes the checker, whatever the method and the agents.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "ascii_map.hpp"
#include "checked_plan.hpp"
#include "random_map.hpp"

namespace waybreaker {
namespace {

Body any_body() {
    const Corners corners = any_corners();
    const double radius = corners == Corners::none ? *rc::gen::element(0.5, 0.5, 0.501, 0.75, 1.2, 2.0, 0.0) : 0.5;
    return {.radius = radius, .corners = corners};
}

Rules any_rules(const Map& map) {
    Rules rules;
    rules.removals = *number(0, 4);
    rules.timing = *rc::gen::element(Timing::enforce, Timing::ignore);
    rules.objective = *rc::gen::element(Objective::makespan, Objective::flowtime, Objective::ground_makespan);
    rules.breach_time = {*rc::gen::element(0.0, 0.0, 2.5), *rc::gen::element(0.0, 0.0, 0.2)};
    rules.protect = some_obstacles(map, 2);
    rules.budget = *rc::gen::element(0.9, 1.7, 2.0, std::numeric_limits<double>::infinity());
    return rules;
}

// A mission that can be put on the map, with agents of their own speeds, starts and goals.
Mission any_mission(const PlainMap& plain, const Map& map, const Body& body) {
    Mission mission = ground_and_air(any_free_cell(plain), any_free_cell(plain));
    const OpenedMap closed(map);
    RC_PRE(fits(closed, mission.agents[0].start, body) && fits(closed, mission.agents[0].goal, body));
    mission.agents[0].body = body;
    mission.rules = any_rules(map);
    if (*rc::gen::arbitrary<bool>()) mission.agents[1].start = any_cell(plain);
    if (*rc::gen::arbitrary<bool>()) mission.agents[1].goal = any_cell(plain);
    mission.agents[0].speed = *rc::gen::element(0.3, 1.0, 1.0, 7.0);
    mission.agents[1].speed = *rc::gen::element(0.5, 1.0, 1.0, 4.0);
    if (*rc::gen::arbitrary<bool>()) std::swap(mission.agents[0], mission.agents[1]);
    return mission;
}

Method any_method() {
    return {.flight = *rc::gen::element(FlightRule::optimal, FlightRule::nearest),
            .bound = *rc::gen::arbitrary<bool>(),
            .explain = *rc::gen::arbitrary<bool>()};
}

// Obstacles weigh as usual, or each half of that or a third more.
Map any_weights(const Map& map) {
    const double weight = *rc::gen::element(0.5, 1.0, 1.0, 1.3);
    return map.with_weights(std::vector<double>(map.obstacles().size() + 1, weight));
}

// The paper's choice and the proven one, with every planner that drives from cell to cell.
RC_GTEST_PROP(EveryPlan, IsValid, ()) {
    const PlainMap plain = *random_map(24, 20);
    const Map map = any_weights(Map(plain.grid(), *rc::gen::element(Connectivity::four, Connectivity::eight)));
    Method method = any_method();
    method.select = *rc::gen::element(Selection::hits, Selection::exact);
    method.planner = *rc::gen::element(Algorithm::theta, Algorithm::lazy_theta, Algorithm::astar, Algorithm::jps,
                                       Algorithm::dijkstra, Algorithm::bfs);
    const Body body = any_body();
    if (method.planner == Algorithm::jps && body.radius > 0.5) method.planner = Algorithm::astar;
    const Mission mission = any_mission(plain, map, body);
    const Plan plan = Planner().plan(map, mission, method);
    RC_ASSERT(plan_faults(map, mission, plan) == "");
}

// The proven choice with the optimal planner, for the unit square and for the point.
RC_GTEST_PROP(EveryPlan, IsValidWithTheOptimalPlanner, ()) {
    const PlainMap plain = *random_map(24, 20);
    const Map map = any_weights(Map(plain.grid(), *rc::gen::element(Connectivity::four, Connectivity::eight)));
    const Mission mission = any_mission(plain, map, *rc::gen::element(Body(), point_body));
    const Plan plan = Planner().plan(map, mission, any_method());
    RC_ASSERT(plan_faults(map, mission, plan) == "");
}

// What is not said weighs 1: it once counted for nothing.
TEST(EveryPlan, KeepsToABudgetWithoutWeights) {
    const Map map = map_from_ascii(R"(
        ..a..b..c..
        ..a..b..c..
        ..a..b..c..)");
    Mission mission = ground_and_air({0, 1}, {10, 1});
    for (const Selection select : {Selection::exact, Selection::hits}) {
        mission.rules = {.removals = 3, .budget = 2};
        const Plan two = Planner().plan(map, mission, {.select = select});
        EXPECT_EQ(two.status, PlanStatus::no_plan);
        EXPECT_LE(two.breaches.size(), 2U);
        EXPECT_EQ(plan_faults(map, mission, two), "");
        mission.rules.budget = 3;
        const Plan three = Planner().plan(map, mission, {.select = select});
        EXPECT_EQ(three.breaches.size(), select == Selection::exact ? 3U : three.breaches.size());
        EXPECT_EQ(plan_faults(map, mission, three), "");
    }
}

}  // namespace
}  // namespace waybreaker
