// Orders that one can draw.
#include "orders/orders.hpp"

#include <gtest/gtest.h>

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
    EXPECT_NEAR(order.after.fraction, 2.0 / 6, 1e-9);
    EXPECT_EQ(order.slack, 0);
}

}  // namespace
}  // namespace waybreaker
