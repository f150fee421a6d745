#include "rehearse/script.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/in_zones.hpp"
#include "rehearse/trail.hpp"

namespace waybreaker::rehearsal {
namespace {

Point place(const Waypoint& p) {
    return {p.x, p.y};
}

bool same_time(double a, double b) {
    return std::abs(a - b) <= 1e-6 * std::max(1.0, std::abs(b));
}

// The stop at that moment of the path; a new one where there is none.
Stop& stop_at(Script& script, const std::vector<Waypoint>& path, std::size_t point, double share) {
    if (share >= 1) {
        ++point;
        share = 0;
    }
    if (point + 1 >= path.size()) {
        point = path.size() - 1;
        share = 0;
    }
    const auto before = [](const Stop& stop, const std::pair<std::size_t, double>& moment) {
        return stop.point != moment.first ? stop.point < moment.first : stop.share < moment.second;
    };
    const auto there = std::lower_bound(script.begin(), script.end(), std::pair(point, share), before);
    if (there != script.end() && there->point == point && there->share == share) return *there;
    Stop stop{.point = point, .share = share, .at = place(path[point])};
    if (share > 0) {
        const Waypoint& a = path[point];
        const Waypoint& b = path[point + 1];
        stop.at = {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
    }
    return *script.insert(there, stop);
}

// The point of an agent's path at which its breach is done. An aircraft that is revised while it leaves the breach cell
// begins beside its centre, by less than one can see; a ground agent stops where it touches.
std::optional<std::size_t> end_of(const Itinerary& agent, const Breach& breach) {
    const bool flies = agent.kind == AgentKind::air;
    if (breach.by.empty() ? !flies : breach.by != agent.id) return std::nullopt;
    std::optional<std::size_t> end;
    double least = flies ? 0.5 : std::numeric_limits<double>::infinity();  // cells
    for (std::size_t i = 0; i < agent.path.size(); ++i) {
        const double away = distance(place(agent.path[i]), Point(breach.at));
        if (away >= least || !same_time(agent.path[i].t, breach.cleared_at)) continue;
        end = i;
        least = away;
    }
    return end;
}

// Where a vehicle stops before an obstacle that is to be opened by others.
void add_gate(const Map& map, const std::vector<Waypoint>& path, double radius, ObstacleId obstacle, Script& script) {
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        const auto share = first_overlap(map, obstacle, place(path[i]), place(path[i + 1]), radius);
        if (!share) continue;
        stop_at(script, path, i, *share).gates.push_back(obstacle);
        return;
    }
}

// Where a vehicle comes to an obstacle that has been removed: as its order for that says, if it has one.
std::optional<Moment> entry_of(const Map& map, const Plan& plan, std::size_t agent, double radius,
                               ObstacleId obstacle) {
    for (const Order& order : plan.orders) {
        if (order.after.agent == agent && order.obstacle == obstacle) return order.after;
    }
    const std::vector<Waypoint>& path = plan.agents[agent].path;
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        const auto share = first_overlap(map, obstacle, place(path[i]), place(path[i + 1]), radius);
        if (share) return Moment{agent, i, *share};
    }
    return std::nullopt;
}

// Stands there for its rubble, once it is open. What the vehicle begins in, it has entered before.
void stand_for_rubble(const std::vector<Waypoint>& path, const Moment& entry, double rubble, Script& script) {
    if (entry.point == 0 && entry.fraction == 0) return;
    const Stop& gate = stop_at(script, path, entry.point, entry.fraction);
    const Stop stand{.point = gate.point, .share = gate.share, .at = gate.at, .work = rubble};
    script.insert(script.begin() + (&gate - script.data()) + 1, stand);
}

void add_rubble(const Map& map, const Mission& mission, const Plan& plan, std::vector<Script>& scripts) {
    std::vector<ObstacleId> removed;
    for (const Breach& breach : plan.breaches) removed.push_back(breach.obstacle);
    for (const TimedOpening& opening : mission.rules.opened) removed.push_back(opening.obstacle);
    for (std::size_t i = 0; i < plan.agents.size(); ++i) {
        if (plan.agents[i].kind == AgentKind::air) continue;
        for (const ObstacleId obstacle : removed) {
            const auto entry = entry_of(map, plan, i, mission.agents[i].body.reach(), obstacle);
            if (entry) stand_for_rubble(plan.agents[i].path, *entry, mission.rules.rubble, scripts[i]);
        }
    }
}

// As planned: who comes early could come into a zone before that is over. Who stands for rubble does so before the time
// at which it goes on from there.
void keep_times(const std::vector<Waypoint>& path, Script& script) {
    double stands = 0;
    for (std::size_t i = script.size(); i-- > 0;) {
        Stop& stop = script[i];
        const Stop* next = i + 1 < script.size() ? &script[i + 1] : nullptr;
        stands = next != nullptr && next->point == stop.point && next->share == stop.share ? stands + next->work : 0;
        double planned = path[stop.point].t;
        if (stop.share > 0) planned += stop.share * (path[stop.point + 1].t - planned);
        stop.on_time = true;
        stop.not_before = std::max(stop.not_before, planned - stands);
    }
}

}  // namespace

bool opens_by_itself(const Rules& rules, ObstacleId id) {
    return std::ranges::find(rules.opened, id, &TimedOpening::obstacle) != rules.opened.end();
}

std::vector<Script> scripts_of(const Map& map, const Mission& mission, const Plan& plan,
                               const std::vector<ObstacleId>& standing) {
    std::vector<Script> scripts(plan.agents.size());
    for (std::size_t i = 0; i < plan.agents.size(); ++i) {
        const Itinerary& agent = plan.agents[i];
        const Agent& asked = mission.agents[i];
        Script& script = scripts[i];
        for (std::size_t k = 0; k < agent.path.size(); ++k) script.push_back({.point = k, .at = place(agent.path[k])});
        for (const Recharge& recharge : agent.recharges) {
            const auto is_end = [&](const Waypoint& p) {
                return p.t == recharge.until && place(p) == Point(recharge.at);
            };
            const auto end = std::ranges::find_if(agent.path, is_end);
            if (end == agent.path.end()) continue;
            Stop& stop = script[std::size_t(end - agent.path.begin())];
            stop.recharges = true;
            stop.work = asked.recharge.value_or(0);
        }
        const std::size_t ready = asked.approach.empty() ? 0 : asked.approach.size() - 1;
        script[std::min(ready, script.size() - 1)].not_before = asked.ready_at;
        for (const Breach& breach : plan.breaches) {
            const std::optional<std::size_t> end = end_of(agent, breach);
            if (!end) continue;
            script[*end].breaches.push_back(breach.obstacle);
            script[*end].work += time_to_breach(asked, map.obstacle(breach.obstacle), mission.rules);
        }
    }
    for (std::size_t i = 0; i < plan.agents.size(); ++i) {
        if (plan.agents[i].kind == AgentKind::air) continue;
        for (const ObstacleId obstacle : standing) {
            add_gate(map, plan.agents[i].path, mission.agents[i].body.reach(), obstacle, scripts[i]);
        }
    }
    for (std::size_t k = 0; k < plan.orders.size(); ++k) {
        const Order& order = plan.orders[k];
        const std::size_t first = order.before.agent;
        const std::size_t second = order.after.agent;
        stop_at(scripts[first], plan.agents[first].path, order.before.point, order.before.fraction)
            .signals.push_back(k);
        stop_at(scripts[second], plan.agents[second].path, order.after.point, order.after.fraction).waits.push_back(k);
    }
    if (mission.rules.rubble > 0) add_rubble(map, mission, plan, scripts);
    for (std::size_t i = 0; i < plan.agents.size(); ++i) {
        const auto has_times = [&](const Zone& zone) {
            return zone.has_window() && holds_for(zone, mission.agents[i]);
        };
        if (std::ranges::any_of(mission.rules.zones, has_times)) keep_times(plan.agents[i].path, scripts[i]);
    }
    return scripts;
}

}  // namespace waybreaker::rehearsal
