#include "rehearse/actor.hpp"

#include <cmath>

namespace waybreaker::rehearsal {
namespace {

// Of the width of a blocked street, half, in cells.
constexpr double half_street = 1.5;

bool is_taken(Cell cell, const std::vector<Actor>& actors, double now) {
    constexpr double margin = 1e-3;
    return std::ranges::any_of(actors, [&](const Actor& actor) {
        if (actor.kind == AgentKind::air) return false;
        const double radius = std::max(actor.radius, 0.1) + margin;
        return overlaps(cell, actor.at(now), radius) || overlaps(cell, actor.script.back().at, radius);
    });
}

}  // namespace

Actor::Actor(const Agent& agent, std::size_t index)
    : number(index),
      kind(agent.kind),
      speed(agent.speed),
      radius(agent.kind == AgentKind::ground ? agent.body.reach() : 0),
      battery(agent.battery()),
      reserve(agent.reserve),
      flown(agent.flown) {
    trail.agent = agent.id;
    trail.kind = kind;
    trail.radius = radius;
}

AgentState Actor::state(double now) const {
    AgentState state{.id = trail.agent, .passed = passed(now), .at = at(now)};
    // Who stands for rubble breaches nothing.
    if (phase == Phase::at_work) state.doing = work.empty() ? Doing::waiting : Doing::breaching;
    if (phase == Phase::lost) state.doing = Doing::lost;
    if (phase == Phase::waiting || phase == Phase::held || phase == Phase::arrived) state.doing = Doing::waiting;
    if (battery != never) state.flown = in_the_air(now);
    return state;
}

std::optional<Point> Actor::ahead(double way, double now) const {
    Point from = at(now);
    for (std::size_t i = stop + 1; i < script.size(); ++i) {
        const Point next = script[i].at;
        const double length = distance(from, next);
        if (length >= way && length > 0) {
            const double share = way / length;
            return Point(from.x + share * (next.x - from.x), from.y + share * (next.y - from.y));
        }
        way -= length;
        from = next;
    }
    return std::nullopt;
}

std::size_t Actor::passed(double now) const {
    const std::size_t last = here().point;
    if (kind == AgentKind::air || phase == Phase::moving || here().share > 0) return last;
    std::size_t first = last;
    while (first > 0 && path[first - 1].x == path[last].x && path[first - 1].y == path[last].y) --first;
    std::size_t point = first;
    while (point < last && path[point + 1].t <= now) ++point;
    return point;
}

double length_of(const std::vector<Waypoint>& path) {
    double length = 0;
    for (std::size_t i = 1; i < path.size(); ++i)
        length += std::hypot(path[i].x - path[i - 1].x, path[i].y - path[i - 1].y);
    return length;
}

std::vector<Cell> rubble_at(const Map& map, Point place, const std::vector<Actor>& actors, double now) {
    std::vector<Cell> cells;
    for (int y = int(std::floor(place.y - half_street)); y <= int(std::ceil(place.y + half_street)); ++y) {
        for (int x = int(std::floor(place.x - half_street)); x <= int(std::ceil(place.x + half_street)); ++x) {
            const Cell cell{x, y};
            if (!map.grid().contains(cell) || map.grid().blocked(cell)) continue;
            if (distance(Point(cell), place) <= half_street && !is_taken(cell, actors, now)) cells.push_back(cell);
        }
    }
    return cells;
}

}  // namespace waybreaker::rehearsal
