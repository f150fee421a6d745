#include "mission/agent_order.hpp"

#include <algorithm>
#include <numeric>
#include <span>
#include <tuple>
#include <utility>

namespace waybreaker {
namespace {

template <class Item>
void put_back(std::vector<Item>& items, std::span<const std::size_t> from) {
    if (items.empty()) return;
    std::vector<Item> placed(items.size());
    for (std::size_t i = 0; i < from.size(); ++i) placed[from[i]] = std::move(items[i]);
    items = std::move(placed);
}

}  // namespace

AgentOrder::AgentOrder(const Mission& mission) : ordered_(mission), from_(mission.agents.size()) {
    std::iota(from_.begin(), from_.end(), std::size_t{0});
    const auto key = [&](std::size_t i) {
        const Agent& agent = mission.agents[i];
        std::vector<std::tuple<double, double, double>> approach;
        for (const Waypoint& at : agent.approach) approach.emplace_back(at.t, at.y, at.x);
        return std::tuple(agent.kind, agent.start.y, agent.start.x, agent.goal.y, agent.goal.x, agent.speed,
                          agent.body.radius, agent.body.corners, agent.ready_at, agent.weight, agent.breaches,
                          agent.own_breaches, agent.begin().y, agent.begin().x, std::move(approach), agent.reach,
                          agent.breach_time, agent.breach_time_per_cell,
                          agent.can_breach ? agent.can_breach->most_cells : 0);
    };
    std::ranges::stable_sort(from_, {}, key);
    for (std::size_t i = 0; i < from_.size(); ++i) ordered_.agents[i] = mission.agents[from_[i]];
}

Plan AgentOrder::restored(Plan plan) const {
    put_back(plan.agents, from_);
    put_back(plan.before.routes, from_);
    put_back(plan.after.routes, from_);
    return plan;
}

}  // namespace waybreaker
