#include "live/detour.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace waybreaker::live {
namespace {

// Of a place that is in a zone by hardly more than rounding: one beside it that is not.
std::optional<Point> just_outside(const Airspace& air, Point at) {
    const Point rounded(std::round(at.x * zone_steps), std::round(at.y * zone_steps));
    for (int step = 1; step <= 8; ++step) {
        for (const int dy : {0, -step, step}) {
            for (const int dx : {0, -step, step}) {
                const Point beside((rounded.x + dx) / zone_steps, (rounded.y + dy) / zone_steps);
                if (air.allows(beside)) return beside;
            }
        }
    }
    return std::nullopt;
}

// The nearest cell outside of zones from which there is a way to another place.
std::optional<Cell> nearest_outside(const Map& map, const Airspace& air, Point at, Point onward) {
    std::optional<Cell> nearest;
    double least = std::numeric_limits<double>::infinity();
    const Cell centre{int(std::lround(at.x)), int(std::lround(at.y))};
    const auto look = [&](Cell cell) {
        const double away = distance(at, Point(cell));
        if (away >= least || !map.grid().contains(cell) || !air.allows(cell)) return;
        if (!std::isfinite(air.length(cell, onward))) return;
        nearest = cell;
        least = away;
    };
    // Ring by ring; no cell of a ring is nearer than half a cell less than its number.
    for (int ring = 0; ring <= std::max(map.width(), map.height()) && ring - 0.5 <= least; ++ring) {
        for (int i = -ring; i <= ring; ++i) {
            look({centre.x + i, centre.y - ring});
            look({centre.x + i, centre.y + ring});
            look({centre.x - ring, centre.y + i});
            look({centre.x + ring, centre.y + i});
        }
    }
    return nearest;
}

void leave_out(std::size_t points, Position& position) {
    position.next += points;
    position.left_out += points;
}

// Off its path it does not come back to places in a zone, which it was to fly out of.
void leave_out_places_inside(const Agent& aircraft, Position& position) {
    std::vector<Waypoint>& ahead = position.ahead;
    const auto outside = std::find_if(ahead.begin() + 1, ahead.end(), [&](const Waypoint& p) {
        return aircraft.airspace.allows({p.x, p.y});
    });
    if (outside == ahead.begin() + 1 || outside == ahead.end()) return;
    leave_out(std::size_t(outside - ahead.begin()) - 1, position);
    const double later =
        ahead[0].t + distance(position.at, Point(outside->x, outside->y)) / aircraft.speed - outside->t;
    ahead.erase(ahead.begin() + 1, outside);
    for (std::size_t i = 1; i < ahead.size(); ++i) ahead[i].t += later;
}

// Zones enclose it: it stays where it is.
void stay(Position& position) {
    leave_out(position.ahead.size() - 1, position);
    position.ahead.resize(1);
    position.detour.clear();
}

}  // namespace

void fly_round_zones(const Map& map, const Agent& aircraft, Position& position) {
    const Airspace& air = aircraft.airspace;
    if (air.is_open() || position.doing == Doing::lost) return;
    if (!position.on_time) leave_out_places_inside(aircraft, position);
    std::vector<Waypoint>& ahead = position.ahead;
    const Point onward = position.finished() ? Point(aircraft.goal) : Point(ahead[1].x, ahead[1].y);
    const bool inside = !air.allows(position.at);
    if (inside && position.on_time && !position.finished()) {
        // On its way out since the plan before.
        position.leaves_zone = ahead[1].t;
        return;
    }
    Waypoint last = ahead.front();
    const auto fly_to = [&](Point p) {
        last = {p.x, p.y, last.t + distance(Point(last.x, last.y), p) / aircraft.speed};
        position.detour.push_back(last);
    };
    if (inside) {
        const std::optional<Point> beside = just_outside(air, position.at);
        const std::optional<Cell> cell = beside ? std::nullopt : nearest_outside(map, air, position.at, onward);
        if (!beside && !cell) return stay(position);
        fly_to(beside ? *beside : Point(*cell));
        position.leaves_zone = last.t;
    }
    if (position.finished() || position.on_time) return;
    const std::vector<Point> way = air.way({last.x, last.y}, onward);
    if (way.empty()) return stay(position);
    for (std::size_t i = 1; i + 1 < way.size(); ++i) fly_to(way[i]);
    const double arrives = last.t + distance(Point(last.x, last.y), onward) / aircraft.speed;
    const double straight = ahead[0].t + distance(position.at, onward) / aircraft.speed;
    for (std::size_t i = 1; i < ahead.size(); ++i) ahead[i].t += arrives - straight;
}

}  // namespace waybreaker::live
