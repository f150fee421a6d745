// Orders that one can draw.
#include "orders/orders.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "ascii_map.hpp"
#include "checked_plan.hpp"
#include "vehicle.hpp"
#include "waybreaker/planner.hpp"

namespace waybreaker {
namespace {

TEST(Orders, OfAnOpening) {
    const Map map = map_from_ascii(R"(
        ...a...
        ####...
        ...b...)");
    Mission mission = ground_and_air({0, 0}, {6, 0});
    mission.rules.breach_time.per_obstacle = 10;
    const Plan plan = Planner().plan(map, mission);
    ASSERT_EQ(plan.status, PlanStatus::solved);
    ASSERT_EQ(plan.orders.size(), 1U);
    const Order& order = plan.orders[0];
    EXPECT_EQ(order.reason, OrderReason::opening);
    EXPECT_EQ(order.obstacle, plan.breaches[0].obstacle);
    EXPECT_EQ(order.before.agent, 1U);
    EXPECT_EQ(plan.agents[1].path[order.before.point].t, plan.breaches[0].cleared_at);
    EXPECT_EQ(order.before.fraction, 0);
    // It touches the obstacle when it leaves (2, 0): on its way from (0, 0), where it has waited.
    EXPECT_EQ(order.after.agent, 0U);
    EXPECT_EQ(order.after.point, 1U);
    EXPECT_NEAR(order.after.fraction, 2.0 / 6, order_clearance);
    EXPECT_EQ(order.slack, 0);
}

TEST(Orders, OfAnOpeningForTheSlowest) {
    const Map map = map_from_ascii(R"(
        ...a...
        ####...
        ...b...)");
    Mission mission = ground_and_air({0, 0}, {6, 0});
    // Rounding in cells is long in time.
    for (const double speed : {least_speed, 1e-5, 1e-4, 1e-3}) {
        mission.agents[0].speed = speed;
        EXPECT_TRUE(is_valid(map, mission, Planner().plan(map, mission))) << speed;
    }
}

Plan driven(const Mission& mission, const std::vector<std::vector<Waypoint>>& paths) {
    Plan plan;
    plan.status = PlanStatus::solved;
    for (std::size_t i = 0; i < paths.size(); ++i) {
        const Agent& agent = mission.agents[i];
        plan.agents.push_back({agent.id, agent.kind, agent.speed, paths[i], agent.start, agent.goal});
    }
    return plan;
}

const Map free_ground(Grid(20, 20));

TEST(Orders, OfACrossing) {
    Mission mission;
    mission.agents = {vehicle("west", {0, 5}, {10, 5}), vehicle("south", {5, 10}, {5, 0})};
    // The second comes to the crossing when the first is 2 cells past it.
    Plan plan = driven(mission, {{{0, 5, 0}, {10, 5, 10}}, {{5, 10, 0}, {5, 10, 2}, {5, 0, 12}}});
    add_orders(free_ground, mission, plan);
    ASSERT_EQ(plan.orders.size(), 1U);
    const Order& order = plan.orders[0];
    EXPECT_EQ(order.reason, OrderReason::passing);
    EXPECT_FALSE(order.obstacle);
    EXPECT_EQ(order.before.agent, 0U);
    EXPECT_EQ(order.before.point, 0U);
    EXPECT_NEAR(order.before.fraction, 0.6, 1e-7);  // one cell past it
    EXPECT_EQ(order.after.agent, 1U);
    EXPECT_EQ(order.after.point, 1U);
    EXPECT_NEAR(order.after.fraction, 0.4, 1e-7);  // one cell before it
    EXPECT_NEAR(order.slack, 0, 1e-6);
}

TEST(Orders, OfOneBehindTheOther) {
    Mission mission;
    mission.agents = {vehicle("first", {4, 5}, {18, 5}), vehicle("second", {0, 5}, {14, 5})};
    Plan plan = driven(mission, {{{4, 5, 0}, {18, 5, 14}}, {{0, 5, 0}, {14, 5, 14}}});
    add_orders(free_ground, mission, plan);
    ASSERT_GT(plan.orders.size(), 5U);  // it need not wait until the first has got to its goal
    for (const Order& order : plan.orders) {
        EXPECT_EQ(order.before.agent, 0U);
        EXPECT_EQ(order.after.agent, 1U);
        EXPECT_GT(order.slack, 1);  // of the three cells between them
    }
}

TEST(Orders, OfWhoStandsInTheWay) {
    Mission mission;
    mission.agents = {vehicle("parked", {5, 5}, {5, 8}), vehicle("through", {0, 5}, {10, 5})};
    mission.agents[0].ready_at = 3;
    Plan plan = driven(mission, {{{5, 5, 0}, {5, 5, 3}, {5, 8, 6}}, {{0, 5, 0}, {10, 5, 10}}});
    add_orders(free_ground, mission, plan);
    ASSERT_FALSE(plan.orders.empty());
    EXPECT_EQ(plan.orders[0].before.agent, 0U);
    EXPECT_EQ(plan.orders[0].before.point, 1U);
    EXPECT_EQ(plan.orders[0].after.agent, 1U);
    EXPECT_NEAR(plan.orders[0].after.fraction, 0.4, 1e-7);
    // One that would stay for ever is gone when it has arrived, if those leave.
    mission.agents[0].goal = {5, 5};
    mission.rules.at_goal = AtGoal::leave;
    plan = driven(mission, {{{5, 5, 0}, {5, 5, 3}}, {{0, 5, 0}, {10, 5, 10}}});
    add_orders(free_ground, mission, plan);
    ASSERT_EQ(plan.orders.size(), 1U);
    EXPECT_EQ(plan.orders[0].before, (Moment{0, 1, 0}));
    EXPECT_NEAR(plan.orders[0].slack, 1, 1e-6);
}

TEST(Orders, OfWhoVanishesBesideTheOther) {
    Mission mission;
    mission.rules.at_goal = AtGoal::leave;
    mission.agents = {vehicle("first", {1, 1}, {4, 1}), vehicle("second", {6, 0}, {3, 1})};
    // From (4, 0) on the second would touch who stands at (4, 1).
    Plan plan = driven(mission, {{{1, 1, 0}, {4, 1, 3}}, {{6, 0, 0}, {6, 0, 2}, {4, 0, 4}, {3, 1, 4 + std::sqrt(2)}}});
    add_orders(free_ground, mission, plan);
    ASSERT_FALSE(plan.orders.empty());
    for (const Order& order : plan.orders) EXPECT_EQ(order.after.agent, 1U);
    EXPECT_EQ(plan.orders.back().before, (Moment{0, 1, 0}));
    EXPECT_LT(plan.orders.back().after.fraction, 1e-7);
}

TEST(Orders, OfVehiclesOnlyWhereTimingIsIgnored) {
    const Map map = map_from_ascii(R"(
        ...a...
        ####...
        ...b...)");
    Mission mission = ground_and_air({0, 0}, {6, 0});
    mission.rules.timing = Timing::ignore;
    const Plan plan = Planner().plan(map, mission);
    ASSERT_EQ(plan.breaches.size(), 1U);
    EXPECT_TRUE(plan.orders.empty());
}

}  // namespace
}  // namespace waybreaker
