// Whoever keeps the orders meets nobody, however late anybody is; whoever leaves one out may.
#include "execution.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "checked_plan.hpp"
#include "orders/orders.hpp"
#include "orders/passing.hpp"
#include "teams.hpp"
#include "waybreaker/planner.hpp"

namespace waybreaker {
namespace {

// Agents go on in any order, as far as it pleases, until all have arrived.
std::string execute_with_delays(const Drawn& drawn, Draws& draws) {
    Execution execution(drawn.map, drawn.mission, drawn.plan, drawn.plan.orders);
    const std::size_t count = drawn.plan.agents.size();
    const bool in_bursts = draws.number(0, 1) == 1;
    for (std::size_t idle = 0; idle < 20 * count;) {
        const auto agent = std::size_t(draws.number(0, int(count) - 1));
        const double limit = execution.limit(agent);
        const double from = execution.progress(agent);
        const double share = in_bursts || draws.number(0, 3) == 0 ? 1 : draws.share();
        idle = limit > from ? 0 : idle + 1;
        if (!execution.go(agent, share == 1 ? limit : from + share * (limit - from))) return execution.fault();
    }
    for (std::size_t i = 0; i < count; ++i) {
        if (execution.progress(i) < execution.end(i)) return drawn.plan.agents[i].id + " waits for ever";
    }
    return "";
}

TEST(Executions, MeetNobodyAndNothingThatStands) {
    for_each_drawn_plan(400, [](const Drawn& drawn, Draws& draws) {
        for (int i = 0; i < 20; ++i) ASSERT_EQ(execute_with_delays(drawn, draws), "");
    });
}

// In a ring everybody waits for the next one, who must not have to be farther ahead than it can be.
TEST(Executions, GoRoundInRings) {
    int rings = 0;
    for (std::uint64_t seed = 1; seed <= 25; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Draws draws(seed);
        PlainMap plain{draws.number(3, 5), draws.number(3, 5), {}};
        for (int i = 0; i < plain.width * plain.height; ++i) plain.obstacles.push_back(draws.number(0, 99) < 8);
        Drawn drawn{Map(plain.grid()), {}, {}};
        drawn.mission = drawn_crowd(draws, plain, drawn.map);
        if (drawn.mission.agents.size() < 2) continue;
        drawn.plan = Planner().plan(drawn.map, drawn.mission);
        if (drawn.plan.status != PlanStatus::solved) continue;
        ASSERT_TRUE(is_valid(drawn.map, drawn.mission, drawn.plan));
        std::vector<orders::Track> tracks;
        for (std::size_t i = 0; i < drawn.plan.agents.size(); ++i) {
            tracks.push_back(
                {drawn.mission.agents[i].body.reach(), orders::stretches(i, drawn.plan.agents[i].path, true)});
        }
        std::vector<Order> coarse;
        for (const orders::Pair& pair : orders::near_pairs(tracks, 0)) {
            orders::add_passing_orders(pair, {order_step}, coarse);
        }
        const std::vector<bool> stuck = orders::stuck_agents(coarse, drawn.plan.agents.size());
        rings += std::ranges::count(stuck, true) > 0 ? 1 : 0;
        for (int i = 0; i < 10; ++i) ASSERT_EQ(execute_with_delays(drawn, draws), "");
    }
    EXPECT_GT(rings, 0);  // they need finer steps than others
}

// The agent that is waited for stops somewhere short of where it has to get; all others go on as far as they can.
bool goes_wrong_without(const Drawn& drawn, std::size_t left_out, Draws& draws) {
    std::vector<Order> orders = drawn.plan.orders;
    const Order order = orders[left_out];
    orders.erase(orders.begin() + std::ptrdiff_t(left_out));
    for (int tries = 0; tries < 40; ++tries) {
        Execution execution(drawn.map, drawn.mission, drawn.plan, orders);
        const double short_of = Execution::number(order.before) - (tries % 2 == 0 ? 1e-3 : draws.share());
        for (bool moved = true; moved;) {
            moved = false;
            for (std::size_t i = 0; i < drawn.plan.agents.size(); ++i) {
                double to = execution.limit(i);
                if (i == order.before.agent) to = std::min(to, short_of);
                if (to <= execution.progress(i)) continue;
                moved = true;
                if (!execution.go(i, to)) return true;
            }
        }
    }
    return false;
}

TEST(Executions, GoWrongWithoutAnyOneOrder) {
    int orders = 0;
    int needed = 0;
    for_each_drawn_plan(100, [&](const Drawn& drawn, Draws& draws) {
        for (std::size_t i = 0; i < drawn.plan.orders.size(); ++i) {
            ++orders;
            needed += goes_wrong_without(drawn, i, draws) ? 1 : 0;
        }
    });
    RecordProperty("orders", orders);
    RecordProperty("needed", needed);
    EXPECT_GT(orders, 300);
    EXPECT_GT(needed, orders * 8 / 10) << orders;
}

double time_of(const Plan& plan, const Moment& moment) {
    const std::vector<Waypoint>& path = plan.agents[moment.agent].path;
    const Waypoint& at = path[moment.point];
    return moment.fraction == 0 ? at.t : std::lerp(at.t, path[moment.point + 1].t, moment.fraction);
}

TEST(Orders, AreKeptByThePlan) {
    int kept = 0;
    int all = 0;
    for_each_drawn_plan(400, [&](const Drawn& drawn, Draws&) {
        for (const Order& order : drawn.plan.orders) {
            const Itinerary& waiting = drawn.plan.agents[order.after.agent];
            ASSERT_LT(order.before.point, drawn.plan.agents[order.before.agent].path.size());
            ASSERT_LT(order.after.point + 1, waiting.path.size());
            for (const Moment& moment : {order.before, order.after}) {
                ASSERT_GE(moment.fraction, 0);
                ASSERT_LT(moment.fraction, 1);
            }
            EXPECT_EQ(waiting.kind, AgentKind::ground);
            EXPECT_NEAR(order.slack, time_of(drawn.plan, order.after) - time_of(drawn.plan, order.before), 1e-7);
            const bool opens = order.reason == OrderReason::opening;
            EXPECT_GE(order.slack, opens ? 0 : -order_step / waiting.speed - 1e-6);
            ++all;
            kept += order.slack >= 0 ? 1 : 0;
        }
    });
    RecordProperty("kept", kept);
    RecordProperty("all", all);
    EXPECT_GT(kept, all / 2) << all;
}

}  // namespace
}  // namespace waybreaker
