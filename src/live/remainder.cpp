#include "live/remainder.hpp"

#include <algorithm>
#include <cmath>

#include "model/bases.hpp"
#include "model/objective.hpp"
#include "model/timeline.hpp"

namespace waybreaker::live {
namespace {

// A base, and then the path ahead; empty where the base leaves it.
std::vector<Waypoint> continued(const Base& base, const Position& position) {
    for (const Waypoint& p : base) {
        const Waypoint there = place_on(position.ahead, p.t);
        if (std::abs(there.x - p.x) > hair || std::abs(there.y - p.y) > hair) return {};
    }
    std::vector<Waypoint> path = base;
    for (const Waypoint& p : position.ahead) {
        if (p.t > base.back().t) path.push_back(p);
    }
    return path;
}

}  // namespace

std::optional<Plan> remainder_of(const Report& report, std::span<const Position> positions,
                                 std::span<const Outlook> outlooks, const Map& known, const Mission& left) {
    const Plan& old = report.plan;
    if (left.agents.size() != old.agents.size() || !report.state.joined.empty()) return std::nullopt;
    Plan rest;
    rest.status = PlanStatus::solved;
    std::vector<TimedOpening> openings = left.rules.opened;
    for (std::size_t i = 0; i < outlooks.size(); ++i) {
        if (outlooks[i].failed) return std::nullopt;
        if (outlooks[i].opens) continue;
        if (known.obstacle(old.breaches[i].obstacle).cells != old.breaches[i].cells) return std::nullopt;
        Breach& kept = rest.breaches.emplace_back(old.breaches[i]);
        // What is open by now counts no more.
        const auto is_open = [&](ObstacleId id) {
            return std::ranges::find(left.rules.opened, id, &TimedOpening::obstacle) != left.rules.opened.end();
        };
        if (kept.if_failed) std::erase_if(kept.if_failed->removed, is_open);
        openings.push_back({old.breaches[i].obstacle, old.breaches[i].cleared_at});
    }
    // Who enters what has opened has taken its time over the rubble.
    for (TimedOpening& opening : openings) opening.at += left.rules.rubble;
    const Ground ground{known, openings};
    Finish finish;
    rest.after.routes.clear();
    for (std::size_t i = 0; i < old.agents.size(); ++i) {
        const Position& position = positions[i];
        const Agent& agent = left.agents[i];
        if (!position.on_time || agent.goal != old.agents[i].goal) return std::nullopt;
        Itinerary itinerary = old.agents[i];
        itinerary.path = position.finished() ? agent.approach : continued(agent.approach, position);
        if (itinerary.path.empty()) return std::nullopt;
        if (agent.kind == AgentKind::ground && ground.first_hit(itinerary.path, agent.body)) return std::nullopt;
        itinerary.recharges = recharges_on(agent, itinerary.path, old.breaches);
        if (agent.kind == AgentKind::air && !keeps_battery(agent, itinerary.path, itinerary.recharges))
            return std::nullopt;
        itinerary.start = agent.start;
        itinerary.gain.reset();
        itinerary.waits.clear();
        finish.add(agent, std::max(itinerary.path.back().t, agent.ready_at));
        Route route{agent.kind};
        route.path = places(itinerary.path);
        if (itinerary.reached) route.length = path_length(route.path);
        rest.after.routes.push_back(std::move(route));
        rest.agents.push_back(std::move(itinerary));
    }
    rest.after.makespan = finish.makespan();
    rest.after.flowtime = finish.flowtime;
    rest.after.ground_makespan = finish.ground;
    return rest;
}

void compare(Plan& rest, const Plan& other, Objective objective) {
    rest.before = other.before;
    rest.limit_reached = other.limit_reached;
    const std::optional<double> reached = value(rest.after, objective);
    if (!other.bound || !reached) return;
    rest.bound = std::min(*other.bound, *reached);
    rest.gap = *rest.bound > 0 ? *reached / *rest.bound - 1 : 0;
}

}  // namespace waybreaker::live
