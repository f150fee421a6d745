#include "io/path_parts.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>

#include "check/contact.hpp"

namespace waybreaker::io {
namespace {

checker::Vertex vertex(const Waypoint& point) {
    return {std::llround(2 * point.x), std::llround(2 * point.y)};
}

// Takes the obstacles that the move touches out of `closed`.
std::vector<ObstacleId> take_touched(std::set<ObstacleId>& closed, const Map& map, const Waypoint& from,
                                     const Waypoint& to, std::int64_t radius) {
    std::set<ObstacleId> touched;
    const auto touch = [&](ObstacleId obstacle) {
        if (closed.erase(obstacle) != 0) touched.insert(obstacle);
    };
    const checker::Leg leg{vertex(from), vertex(to), from.t, to.t};
    for (const checker::Contact& contact : checker::contacts(map, leg, radius)) touch(contact.obstacle);
    if (radius == 0) {
        for (const checker::Passage& passage : checker::side_passages(map, leg)) {
            touch(passage.first);
            touch(passage.second);
        }
    }
    return {touched.begin(), touched.end()};
}

}  // namespace

std::vector<ObstacleId> openings_of(const Mission& mission, const Plan& plan) {
    std::set<ObstacleId> openings;
    for (const Breach& breach : plan.breaches) openings.insert(breach.obstacle);
    const double begins = plan.revised ? plan.revised->now : 0;
    for (const TimedOpening& opening : mission.rules.opened) {
        if (opening.at > begins) openings.insert(opening.obstacle);
    }
    return {openings.begin(), openings.end()};
}

std::optional<std::size_t> decision_point(const Plan& plan, std::string_view agent) {
    if (!plan.revised) return std::nullopt;
    const auto decision = std::ranges::find(plan.revised->decisions, agent, &Decision::agent);
    return decision == plan.revised->decisions.end() ? std::nullopt : std::optional(decision->point);
}

std::vector<PathPart> path_parts(const Map& map, const Mission& mission, const Plan& plan, std::size_t agent) {
    const Itinerary& itinerary = plan.agents.at(agent);
    const std::int64_t radius = mission.agents.at(agent).body.thousandths();
    const std::optional<std::size_t> decision = decision_point(plan, itinerary.id);
    std::set<ObstacleId> closed;
    if (itinerary.kind == AgentKind::ground) {
        const std::vector<ObstacleId> openings = openings_of(mission, plan);
        closed.insert(openings.begin(), openings.end());
    }
    std::vector<PathPart> parts;
    bool cut = true;
    for (std::size_t i = 1; i < itinerary.path.size(); ++i) {
        const Waypoint& from = itinerary.path[i - 1];
        const Waypoint& to = itinerary.path[i];
        cut = cut || decision == i - 1;
        if (from.x == to.x && from.y == to.y) {
            cut = cut || to.t > from.t;
            if (!cut) parts.back().last = i;
            continue;
        }
        std::vector<ObstacleId> openings;
        if (!closed.empty()) openings = take_touched(closed, map, from, to, radius);
        if (cut || !openings.empty()) parts.push_back({.first = i - 1, .openings = std::move(openings)});
        parts.back().last = i;
        cut = false;
    }
    return parts;
}

}  // namespace waybreaker::io
