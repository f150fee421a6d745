#include "rehearse/blocked_street.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace waybreaker::rehearsal {
namespace {

// Of the width of a blocked street, half, in cells.
constexpr double half_street = 1.5;

// So far ahead on its path, or nowhere.
std::optional<Point> ahead_of(const Actor& actor, double way, double now) {
    Point at = actor.at(now);
    for (std::size_t i = actor.stop + 1; i < actor.script.size(); ++i) {
        const Point next = actor.script[i].at;
        const double length = distance(at, next);
        if (length >= way && length > 0) {
            const double share = way / length;
            return Point(at.x + share * (next.x - at.x), at.y + share * (next.y - at.y));
        }
        way -= length;
        at = next;
    }
    return std::nullopt;
}

bool is_taken(Cell cell, std::span<const Actor> actors, double now) {
    constexpr double margin = 1e-3;
    return std::ranges::any_of(actors, [&](const Actor& actor) {
        if (actor.kind == AgentKind::air) return false;
        const double radius = std::max(actor.radius, 0.1) + margin;
        return overlaps(cell, actor.at(now), radius) || overlaps(cell, actor.script.back().at, radius);
    });
}

}  // namespace

Found blocked_street(const Map& map, const Actor& finder, std::span<const Actor> actors, double sight, double now) {
    Found found;
    const std::optional<Point> place = ahead_of(finder, sight, now);
    if (!place) return found;
    for (int y = int(std::floor(place->y - half_street)); y <= int(std::ceil(place->y + half_street)); ++y) {
        for (int x = int(std::floor(place->x - half_street)); x <= int(std::ceil(place->x + half_street)); ++x) {
            const Cell cell{x, y};
            if (!map.grid().contains(cell) || map.grid().blocked(cell)) continue;
            if (distance(Point(cell), *place) <= half_street && !is_taken(cell, actors, now))
                found.cells.push_back(cell);
        }
    }
    return found;
}

}  // namespace waybreaker::rehearsal
