#include "io/path_parts.hpp"

#include <cmath>
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

std::vector<PathPart> path_parts(const Map& map, const Plan& plan, const Itinerary& agent, std::int64_t radius) {
    std::set<ObstacleId> closed;
    if (agent.kind == AgentKind::ground) {
        for (const Breach& breach : plan.breaches) closed.insert(breach.obstacle);
    }
    std::vector<PathPart> parts;
    bool cut = true;
    for (std::size_t i = 1; i < agent.path.size(); ++i) {
        const Waypoint& from = agent.path[i - 1];
        const Waypoint& to = agent.path[i];
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
