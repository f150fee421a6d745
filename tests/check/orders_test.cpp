// Orders that are wrong are found.
#include <gtest/gtest.h>

#include <cmath>

#include "checked_plan.hpp"
#include "orders/teams.hpp"

namespace waybreaker {
namespace {

bool is_found(const Drawn& drawn, const Plan& plan) {
    const std::vector<Violation> violations = check(drawn.map, drawn.mission, plan);
    EXPECT_TRUE(std::ranges::all_of(violations, [](const Violation& v) { return v.rule == Rule::orders; }));
    return !violations.empty();
}

// So much farther on the way, in cells; empty if that is beyond the move.
std::optional<Moment> moved(const Plan& plan, Moment moment, double cells) {
    const std::vector<Waypoint>& path = plan.agents[moment.agent].path;
    if (cells < 0 && moment.fraction == 0) {
        if (moment.point == 0) return std::nullopt;
        --moment.point;
        moment.fraction = 1;
    }
    if (moment.point + 1 >= path.size()) return std::nullopt;
    const Waypoint& a = path[moment.point];
    const Waypoint& b = path[moment.point + 1];
    moment.fraction += cells / std::hypot(b.x - a.x, b.y - a.y);
    return moment.fraction > 0 && moment.fraction < 1 ? std::optional(moment) : std::nullopt;
}

double time_of(const Plan& plan, const Moment& moment) {
    const std::vector<Waypoint>& path = plan.agents[moment.agent].path;
    const double from = path[moment.point].t;
    return moment.fraction == 0 ? from : from + moment.fraction * (path[moment.point + 1].t - from);
}

struct Count {
    int tried = 0;
    int found = 0;
    void add(bool is_found) {
        ++tried;
        found += is_found ? 1 : 0;
    }
};

TEST(CheckOrders, FindsWhatIsFalsified) {
    Count left_out;
    Count too_early;
    for_each_drawn_plan(60, [&](const Drawn& drawn, Draws&) {
        ASSERT_TRUE(is_valid(drawn.map, drawn.mission, drawn.plan));
        for (std::size_t i = 0; i < drawn.plan.orders.size(); ++i) {
            const auto falsified = [&](const auto& change) {
                Plan plan = drawn.plan;
                change(plan.orders[i]);
                return is_found(drawn, plan);
            };
            Plan without = drawn.plan;
            without.orders.erase(without.orders.begin() + std::ptrdiff_t(i));
            left_out.add(is_found(drawn, without));
            EXPECT_TRUE(falsified([](Order& order) { order.slack += 0.01; }));
            EXPECT_TRUE(falsified([](Order& order) { std::swap(order.before, order.after); }));
            EXPECT_TRUE(falsified([](Order& order) { order.before.point += 1000; }));
            EXPECT_TRUE(falsified([](Order& order) { order.after.agent += 1000; }));
            EXPECT_TRUE(falsified([](Order& order) { order.after.fraction = 1; }));
            EXPECT_TRUE(falsified([](Order& order) { order.slack = std::nan(""); }));
            EXPECT_TRUE(falsified([](Order& order) { order.obstacle = {order.obstacle ? 0U : 1U}; }));
            // Somebody is waited for who is not out of the way yet, or too late.
            const Order& order = drawn.plan.orders[i];
            const auto before = moved(drawn.plan, order.before, -0.1);
            const auto after = moved(drawn.plan, order.after, 0.1);
            for (const auto& [from, to] :
                 {std::pair(before, std::optional(order.after)), std::pair(std::optional(order.before), after)}) {
                if (!from || !to) continue;
                too_early.add(falsified([&](Order& other) {
                    other.before = *from;
                    other.after = *to;
                    other.slack = time_of(drawn.plan, *to) - time_of(drawn.plan, *from);
                }));
            }
        }
    });
    EXPECT_GT(left_out.tried, 300);
    EXPECT_GT(too_early.tried, 300);
    EXPECT_GE(left_out.found, left_out.tried * 97 / 100) << left_out.tried;
    EXPECT_GE(too_early.found, too_early.tried * 97 / 100) << too_early.tried;
}

TEST(CheckOrders, FindsRings) {
    for_each_drawn_plan(60, [&](const Drawn& drawn, Draws&) {
        const auto passes = [](const Order& order) { return order.reason == OrderReason::passing; };
        const auto one = std::ranges::find_if(drawn.plan.orders, passes);
        if (one == drawn.plan.orders.end()) return;
        // Whom it waits for waits for it, from the start to the end of both.
        Plan plan = drawn.plan;
        Order back = *one;
        back.before = {one->after.agent, plan.agents[one->after.agent].path.size() - 1, 0};
        back.after = {one->before.agent, 0, 0};
        back.slack = time_of(plan, back.after) - time_of(plan, back.before);
        plan.orders.push_back(back);
        EXPECT_TRUE(is_found(drawn, plan));
    });
}

}  // namespace
}  // namespace waybreaker
