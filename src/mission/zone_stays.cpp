#include "mission/zone_stays.hpp"

#include <algorithm>
#include <limits>

#include "model/in_zones.hpp"

namespace waybreaker {
namespace {

double hair_at(double time) {
    return 1e-9 * (1 + time);
}

Point place(const Waypoint& p) {
    return {p.x, p.y};
}

// From when it is ready, of one that is under way: what it does before is not the plan's.
std::vector<Waypoint> judged_part(const Agent& agent, std::span<const Waypoint> path) {
    const auto is_before = [&](const Waypoint& p) { return !agent.approach.empty() && p.t < agent.ready_at; };
    const auto first = std::ranges::find_if_not(path, is_before);
    return {first, path.end()};
}

// Whether the zone holds for more of a stay than what it takes to cross its outline.
bool is_breached(const Zone& zone, const Stay& stay, double speed) {
    const double across = zones::margin / speed;
    const double from = std::max(zone.from, stay.from + (stay.entered ? across : 0));
    const double until = std::min(zone.until, stay.until - (stay.left ? across : 0));
    return until - from > hair_at(from);
}

std::optional<ZoneBreach> first_of(const std::vector<ZoneBreach>& breaches) {
    if (breaches.empty()) return std::nullopt;
    return *std::ranges::min_element(breaches, {}, &ZoneBreach::at);
}

}  // namespace

std::vector<Stay> stays_in(const zones::Closed& zone, std::span<const Waypoint> path, double radius, bool stays) {
    std::vector<Stay> found;
    double driven = 0;
    for (std::size_t i = 1; i < path.size(); ++i) {
        const Waypoint& a = path[i - 1];
        const Waypoint& b = path[i];
        const double length = distance(place(a), place(b));
        if (b.t > a.t) {
            for (const zones::Stretch& part : zone.stretches(place(a), place(b), radius)) {
                const double from = a.t + part.from * (b.t - a.t);
                const double until = a.t + part.to * (b.t - a.t);
                const bool goes_on = !found.empty() && from - found.back().until <= hair_at(from);
                if (goes_on) {
                    found.back().until = until;
                } else {
                    found.push_back({from, until, driven + part.from * length});
                }
            }
        }
        driven += length;
    }
    const auto is_in = [&](const Waypoint& p) { return !zone.stretches(place(p), place(p), radius).empty(); };
    if (path.empty()) return found;
    const Waypoint& end = path.back();
    if (is_in(end)) {
        const bool is_open = !found.empty() && end.t - found.back().until <= hair_at(end.t);
        if (!is_open) found.push_back({end.t, end.t, driven});
        found.back().left = false;
        if (stays) found.back().until = std::numeric_limits<double>::infinity();
    }
    if (!found.empty() && is_in(path.front())) found.front().entered = false;
    return found;
}

ZoneWatch::ZoneWatch(const Map& map, const Mission& mission) : mission_(mission) {
    const std::vector<Zone>& zones = mission.rules.zones;
    for (std::size_t zone = 0; zone < zones.size(); ++zone) {
        if (zones[zone].has_window()) closed_.try_emplace(zone, zones[zone], map.width(), map.height());
    }
}

bool ZoneWatch::holds_for(std::size_t zone, std::size_t agent) const {
    return waybreaker::holds_for(mission_.rules.zones[zone], mission_.agents[agent]);
}

std::vector<Stay> ZoneWatch::stays(std::size_t zone, std::size_t agent, std::span<const Waypoint> path,
                                   bool stays) const {
    const Agent& asked = mission_.agents[agent];
    const double radius = asked.kind == AgentKind::ground ? asked.body.reach() : 0;
    return stays_in(closed_.at(zone), path, radius, stays);
}

void ZoneWatch::add_first_breach(std::size_t zone, std::size_t agent, std::span<const Waypoint> path,
                                 std::vector<ZoneBreach>& breaches) const {
    const Zone& given = mission_.rules.zones[zone];
    const Agent& asked = mission_.agents[agent];
    const bool vanishes = asked.kind == AgentKind::ground && mission_.rules.at_goal == AtGoal::leave;
    const std::vector<Stay> all = stays(zone, agent, judged_part(asked, path), !vanishes);
    const auto is_one = [&](const Stay& stay) { return is_breached(given, stay, asked.speed); };
    const auto first = std::ranges::find_if(all, is_one);
    if (first != all.end()) breaches.push_back({zone, agent, std::max(given.from, first->from), *first});
}

std::optional<ZoneBreach> ZoneWatch::first_breach(const Plan& plan, const std::vector<bool>& passed) const {
    std::vector<ZoneBreach> breaches;
    for (const auto& [zone, closed] : closed_) {
        if (passed[zone]) continue;
        for (std::size_t agent = 0; agent < plan.agents.size(); ++agent) {
            if (holds_for(zone, agent)) add_first_breach(zone, agent, plan.agents[agent].path, breaches);
        }
    }
    return first_of(breaches);
}

std::optional<ZoneBreach> ZoneWatch::first_breach(std::size_t agent, std::span<const Waypoint> path) const {
    std::vector<ZoneBreach> breaches;
    for (const auto& [zone, closed] : closed_) {
        if (holds_for(zone, agent)) add_first_breach(zone, agent, path, breaches);
    }
    return first_of(breaches);
}

}  // namespace waybreaker
