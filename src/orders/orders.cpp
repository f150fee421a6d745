#include "orders/orders.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <tuple>
#include <vector>

#include "model/timeline.hpp"
#include "orders/passing.hpp"
#include "orders/track.hpp"

namespace waybreaker {
namespace {

using orders::Precision;

// When its agent has breached an obstacle: it has got to the point of its path where it has stayed for that, or it
// passes the place without a stop. Of points at one time, where nothing takes time, it is the last.
Moment breach_of(const Breach& breach, std::size_t agent, const std::vector<Waypoint>& path) {
    const double rounding = 1e-9 * std::max(1.0, breach.cleared_at);
    const auto later =
        std::ranges::partition_point(path, [&](const Waypoint& at) { return at.t <= breach.cleared_at + rounding; });
    if (later == path.begin()) return {agent, 0, 0};
    const auto point = std::size_t(later - path.begin()) - 1;
    if (later == path.end() || path[point].t >= breach.cleared_at - rounding) return {agent, point, 0};
    return {agent, point, (breach.cleared_at - path[point].t) / (later->t - path[point].t)};
}

// Of one ground and one air agent the plan does not say who breaches.
std::size_t breacher_of(const Breach& breach, const Plan& plan) {
    const auto is_it = [&](const Itinerary& agent) {
        return breach.by.empty() ? agent.kind == AgentKind::air : agent.id == breach.by;
    };
    return std::size_t(std::ranges::find_if(plan.agents, is_it) - plan.agents.begin());
}

void add_opening_orders(const Map& map, const Mission& mission, Plan& plan) {
    for (const Breach& breach : plan.breaches) {
        const std::size_t by = breacher_of(breach, plan);
        if (by == plan.agents.size()) continue;
        const Moment before = breach_of(breach, by, plan.agents[by].path);
        for (std::size_t i = 0; i < plan.agents.size(); ++i) {
            if (plan.agents[i].kind == AgentKind::air || i == by) continue;
            const std::vector<Waypoint>& path = plan.agents[i].path;
            // Who only grazes it, give or take rounding, does not enter.
            const double radius = std::max(standing_radius(mission.agents[i].body) - order_clearance, 0.0);
            const auto touch = first_touch_on(map, breach.obstacle, path, radius);
            if (!touch) continue;
            const Moment after = orders::departure(i, path, touch->move, touch->share);
            const double slack = orders::slack_of(breach.cleared_at, touch->time);
            plan.orders.push_back({before, after, OrderReason::opening, breach.obstacle, slack});
        }
    }
}

// Ever finer where agents would wait for each other in a ring.
void add_passing_orders(const Mission& mission, Plan& plan) {
    std::vector<orders::Track> tracks;
    for (std::size_t i = 0; i < plan.agents.size(); ++i) {
        if (plan.agents[i].kind == AgentKind::air) continue;
        tracks.push_back({mission.agents[i].body.reach(),
                          orders::stretches(i, plan.agents[i].path, mission.rules.at_goal == AtGoal::stay)});
    }
    if (tracks.size() < 2) return;
    std::vector<orders::Pair> pairs = orders::near_pairs(tracks, mission.rules.separation);
    // Who comes later is where it comes, whatever others do.
    const auto begins = [&](std::size_t agent) { return plan.agents[agent].path.front().t; };
    std::erase_if(pairs,
                  [&](const orders::Pair& pair) { return begins(pair.one->agent) != begins(pair.other->agent); });
    constexpr std::array<Precision, 4> precisions{
        {{order_step}, {order_step / 16}, {order_step / 256}, {order_step / 256, true}}};
    std::vector<std::size_t> precision(plan.agents.size());  // of orders between two agents that need one as fine
    for (bool done = false; !done;) {
        std::vector<Order> found;
        for (const orders::Pair& pair : pairs) {
            const std::size_t which = std::min(precision[pair.one->agent], precision[pair.other->agent]);
            orders::add_passing_orders(pair, precisions[which], found);
        }
        orders::leave_out_implied(found);
        std::vector<Order> all = found;
        all.insert(all.end(), plan.orders.begin(), plan.orders.end());
        const std::vector<bool> stuck = orders::stuck_agents(all, plan.agents.size());
        done = true;
        for (std::size_t i = 0; i < stuck.size(); ++i) {
            if (!stuck[i] || precision[i] + 1 == precisions.size()) continue;
            ++precision[i];
            done = false;
        }
        if (done) plan.orders.insert(plan.orders.end(), found.begin(), found.end());
    }
}

}  // namespace

void add_orders(const Map& map, const Mission& mission, Plan& plan) {
    plan.orders.clear();
    if (mission.rules.timing == Timing::enforce) add_opening_orders(map, mission, plan);
    if (mission.rules.collisions) add_passing_orders(mission, plan);
    std::ranges::sort(plan.orders, {}, [](const Order& order) {
        return std::tuple(order.after, order.before, order.reason, order.obstacle);
    });
}

}  // namespace waybreaker
