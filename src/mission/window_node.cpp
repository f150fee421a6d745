#include "mission/window_node.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "model/timeline.hpp"
#include "safe_interval/motion.hpp"
#include "safe_interval/traffic.hpp"

namespace waybreaker {
namespace {

using safe_interval::Leg;

constexpr double for_ever = std::numeric_limits<double>::infinity();

// Whether an agent can stand at its start for longer, and nobody who is bound to come past runs into it.
bool can_stand(const Mission& mission, const WindowNode& node, std::size_t late) {
    const Agent& agent = node.agents[late];
    if (agent.kind == AgentKind::air || agent.approach.empty() || !mission.rules.collisions) return true;
    const Leg standing{{agent.begin().x, agent.begin().y}, {}, agent.ready_at, for_ever};
    for (std::size_t i = 0; i < node.agents.size(); ++i) {
        const Agent& other = node.agents[i];
        if (i == late || other.kind == AgentKind::air) continue;
        const double reach = agent.body.reach() + other.body.reach() + mission.rules.separation -
                             safe_interval::TrafficIndex::planning_slack;
        const auto meets = [&](const Leg& leg) { return !safe_interval::overlap(leg, standing, reach).empty(); };
        if (std::ranges::any_of(safe_interval::TrafficIndex::legs(other.approach, false), meets)) return false;
    }
    return true;
}

// So that it is at the zone when that is over. Vehicles wait at their starts as well as on their way; what they breach
// themselves, and all that aircraft do, takes the same time later.
double time_past(const Agent& agent, const Zone& zone, const Stay& stay) {
    const bool works = agent.kind == AgentKind::air || agent.own_breaches > 0;
    return works ? agent.ready_at + (zone.until - stay.from) : zone.until - stay.driven / agent.speed;
}

void set_out_at(double time, Agent& agent) {
    if (!agent.approach.empty()) agent.approach.push_back({agent.begin().x, agent.begin().y, time});
    // In the air it hovers.
    if (!agent.approach.empty() && std::isfinite(agent.battery())) agent.flown += time - agent.ready_at;
    agent.ready_at = time;
}

}  // namespace

Mission WindowNode::mission_in(const Mission& asked) const {
    Mission mission = asked;
    mission.agents = agents;
    mission.rules.zones.clear();
    for (std::size_t i = 0; i < permanent.size(); ++i) {
        const Zone& zone = asked.rules.zones[i];
        if (zone.has_window() && !permanent[i]) continue;
        Zone& imposed = mission.rules.zones.emplace_back(zone);
        imposed.from = 0;
        imposed.until = for_ever;
    }
    return mission;
}

void WindowNode::begin_as_asked(const Mission& asked, Plan& plan) const {
    if (plan.status != PlanStatus::solved) return;
    for (std::size_t i = 0; i < agents.size(); ++i) {
        if (!is_at_entry(asked, i)) continue;
        Itinerary& itinerary = plan.agents[i];
        std::vector<Waypoint> path = agents[i].approach;
        std::ranges::copy_if(itinerary.path, std::back_inserter(path),
                             [&](const Waypoint& p) { return p.t > agents[i].ready_at; });
        path.erase(std::ranges::unique(path).begin(), path.end());
        Route& route = plan.after.routes[i];
        route.path = places(path);
        if (itinerary.reached) route.length = path_length(route.path);
        itinerary.path = std::move(path);
        itinerary.start = asked.agents[i].start;
    }
}

bool WindowNode::is_at_entry(const Mission& asked, std::size_t agent) const {
    return agents[agent].from != asked.agents[agent].from;
}

bool WindowNode::is_anybody_late(const Mission& asked) const {
    return !std::ranges::equal(agents, asked.agents, {}, &Agent::ready_at, &Agent::ready_at);
}

bool WindowNode::imposes_the_same(const WindowNode& other) const {
    const auto are_alike = [](const Agent& a, const Agent& b) {
        return a.ready_at == b.ready_at && a.approach == b.approach;
    };
    return permanent == other.permanent && std::ranges::equal(agents, other.agents, are_alike);
}

std::optional<WindowNode> WindowNode::put_off(const Mission& asked, const ZoneBreach& late) const {
    const Zone& zone = asked.rules.zones[late.zone];
    if (std::isinf(zone.until) || !late.stay.entered || !can_stand(asked, *this, late.agent)) return std::nullopt;
    WindowNode next{agents, permanent};
    Agent& agent = next.agents[late.agent];
    const double time = time_past(agent, zone, late.stay);
    if (time <= agent.ready_at) return std::nullopt;
    set_out_at(time, agent);
    return next;
}

}  // namespace waybreaker
