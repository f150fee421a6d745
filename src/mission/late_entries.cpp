#include "mission/late_entries.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "zones/shape.hpp"

namespace waybreaker {
namespace {

constexpr double relative_rounding = 1e-12;
constexpr double hair = 2.0 / zone_steps;  // cells: to the outer side, whatever rounding does

// Where a flight bends last before it enters.
struct Bend {
    Point at;
    double flown = 0;  // until then, in cells
};

struct Segment {
    Point from;
    Point to;

    Point at(double share) const { return {from.x + share * (to.x - from.x), from.y + share * (to.y - from.y)}; }
};

// Of an edge whose interior is on the left. Who is on the line itself is on the outer side as well.
bool is_outside(const Segment& edge, Point p) {
    const auto& [a, b] = edge;
    const double turned = (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
    const double scale =
        (std::abs(a.x) + std::abs(b.x) + std::abs(p.x)) * (std::abs(a.y) + std::abs(b.y) + std::abs(p.y));
    return turned <= relative_rounding * scale;
}

bool is_on_map(Point p, const Map& map) {
    return p.x >= -0.5 && p.y >= -0.5 && p.x <= map.width() - 0.5 && p.y <= map.height() - 0.5;
}

// What of it is on the map.
std::optional<Segment> on_map(const Segment& edge, const Map& map) {
    double least = 0;
    double most = 1;
    const auto clip = [&](double from, double to, double low, double high) {
        if (from == to) {
            if (from < low || from > high) most = -1;
            return;
        }
        const auto [first, second] = std::minmax({(low - from) / (to - from), (high - from) / (to - from)});
        least = std::max(least, first);
        most = std::min(most, second);
    };
    clip(edge.from.x, edge.to.x, -0.5, map.width() - 0.5);
    clip(edge.from.y, edge.to.y, -0.5, map.height() - 0.5);
    if (least > most) return std::nullopt;
    return Segment{edge.at(least), edge.at(most)};
}

// A hair to the outer side of a place on an edge, on the map.
Point beside(const Segment& edge, Point p, const Map& map) {
    const double length = distance(edge.from, edge.to);
    const Point out(p.x + hair * (edge.to.y - edge.from.y) / length, p.y - hair * (edge.to.x - edge.from.x) / length);
    const Point on_map(std::clamp(out.x, -0.5, map.width() - 0.5), std::clamp(out.y, -0.5, map.height() - 0.5));
    return zones::point_of(zones::spot_of(on_map));
}

// Where a convex function is least, to within rounding.
template <class Function>
Point least_on(const Segment& segment, const Function& value) {
    constexpr int steps = 100;
    double least = 0;
    double most = 1;
    for (int i = 0; i < steps; ++i) {
        const double a = least + (most - least) / 3;
        const double b = most - (most - least) / 3;
        if (value(segment.at(a)) <= value(segment.at(b))) {
            most = b;
        } else {
            least = a;
        }
    }
    return segment.at((least + most) / 2);
}

// Ways bend on the map only.
std::vector<Bend> bends_of(const Map& map, const Agent& aircraft, std::span<const Zone> around) {
    std::vector<Bend> bends{{aircraft.begin(), 0}};
    for (const Zone& zone : around) {
        if (zone.kind != ZoneKind::no_fly) continue;
        for (const zones::Edge& edge : zones::shape_of(zone).edges) {
            const Point corner = zones::point_of(edge.from);
            if (!is_on_map(corner, map)) continue;
            const double flown = aircraft.airspace.length(aircraft.begin(), corner);
            if (std::isfinite(flown)) bends.push_back({corner, flown});
        }
    }
    return bends;
}

struct Entry {
    const Segment& edge;
    const Bend& bend;
    Point at;  // on the edge
    double enters_at = 0;
    double arrival = 0;
};

// For each edge on the map, and each place from which an aircraft may come to it, whether it sees it or not: where and
// when it enters best. `opens`: when it may, if it comes by then at the earliest.
template <class Opens, class Visit>
void for_each_entry(const Map& map, const Agent& aircraft, std::span<const Zone> around, const Zone& zone, Point place,
                    const Opens& opens, const Visit& visit) {
    const std::vector<Bend> bends = bends_of(map, aircraft, around);
    const zones::Shape shape = zones::shape_of(zone);
    for (const zones::Edge& edge : shape.edges) {
        const Segment line{zones::point_of(edge.from), zones::point_of(edge.to)};
        const std::optional<Segment> part = on_map(line, map);
        if (!part) continue;
        for (const Bend& bend : bends) {
            if (!is_outside(line, bend.at)) continue;
            const auto comes_at = [&](Point at) {
                return aircraft.ready_at + (bend.flown + distance(bend.at, at)) / aircraft.speed;
            };
            const double open = opens(comes_at(least_on(*part, comes_at)));
            const auto enters_at = [&](Point at) { return std::max(comes_at(at), open); };
            const auto arrival = [&](Point at) { return enters_at(at) + distance(at, place) / aircraft.speed; };
            const Point at = least_on(*part, arrival);
            visit(Entry{line, bend, at, enters_at(at), arrival(at)});
        }
    }
}

}  // namespace

double least_arrival_past(const Map& map, const Agent& aircraft, std::span<const Zone> around, const Zone& zone,
                          Point place) {
    double least = std::numeric_limits<double>::infinity();
    const auto opens = [&](double comes_at) { return comes_at < zone.from ? 0 : zone.until; };
    for_each_entry(map, aircraft, around, zone, place, opens,
                   [&](const Entry& entry) { least = std::min(least, entry.arrival); });
    return least * (1 - relative_rounding);
}

std::optional<LateEntry> earliest_entry(const Map& map, const Agent& aircraft, std::span<const Zone> around,
                                        const Zone& zone, Point place) {
    std::optional<LateEntry> best;
    const auto opens = [&](double /*comes_at*/) { return zone.until; };
    for_each_entry(map, aircraft, around, zone, place, opens, [&](const Entry& entry) {
        if (best && best->arrival <= entry.arrival) return;
        const Point at = beside(entry.edge, entry.at, map);
        if (aircraft.airspace.is_clear(entry.bend.at, at)) best = LateEntry{at, entry.enters_at, entry.arrival};
    });
    return best;
}

std::optional<Agent> come_to(const Map& map, const LateEntry& entry, const Agent& asked, Agent aircraft) {
    const std::vector<Point> way = aircraft.airspace.way(aircraft.begin(), entry.at);
    if (way.empty()) return std::nullopt;
    // Centres of cells are whole; the map ends half a cell beyond the last.
    const Cell cell{std::clamp(int(std::lround(entry.at.x)), 0, map.width() - 1),
                    std::clamp(int(std::lround(entry.at.y)), 0, map.height() - 1)};
    double length = 0;
    for (std::size_t i = 1; i < way.size(); ++i) length += distance(way[i - 1], way[i]);
    const double leaves_at = std::max(entry.enters_at - length / aircraft.speed, aircraft.ready_at);
    std::vector<Waypoint>& path = aircraft.approach;
    if (path.empty()) path.push_back({way[0].x, way[0].y, 0});
    // Who is at an earlier entry comes to that later, too.
    for (std::size_t i = std::max<std::size_t>(asked.approach.size(), 1); i < path.size(); ++i)
        path[i].t += leaves_at - aircraft.ready_at;
    const double took_off = path.size() > 1 && asked.approach.empty() ? path[1].t : leaves_at;
    double flown = 0;
    for (std::size_t i = 0; i < way.size(); ++i) {
        if (i > 0) flown += distance(way[i - 1], way[i]);
        path.push_back({way[i].x, way[i].y, leaves_at + flown / aircraft.speed});
    }
    aircraft.start = cell;
    aircraft.from = entry.at;
    aircraft.ready_at = path.back().t;
    if (std::isfinite(asked.battery()))
        aircraft.flown = asked.flown + aircraft.ready_at - (asked.approach.empty() ? took_off : asked.ready_at);
    if (aircraft.recharge && aircraft.bases.empty()) aircraft.bases = {asked.start, asked.goal};
    aircraft.airspace = {};
    return aircraft;
}

}  // namespace waybreaker
