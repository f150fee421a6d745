// Zones judged in another way than src/zones does: in doubles, on polygons whose corners are small whole numbers, where
// different results differ by far more than rounding.
#pragma once

#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "waybreaker/airspace.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker {

inline double away_from(Point p, Point a, Point b) {
    const double dx = b.x - a.x;
    const double dy = b.y - a.y;
    const double square = dx * dx + dy * dy;
    const double share = square == 0 ? 0 : std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / square, 0.0, 1.0);
    return std::hypot(p.x - a.x - share * dx, p.y - a.y - share * dy);
}

template <class Visit>
void for_each_edge(const Zone& zone, const Visit& visit) {
    for (const std::vector<Point>& ring : zone.polygon) {
        for (std::size_t i = 0; i < ring.size(); ++i) visit(ring[i], ring[(i + 1) % ring.size()]);
    }
}

// By the angles at which the corners are seen.
inline bool slowly_inside(const Zone& zone, Point p) {
    double turned = 0;
    bool on_edge = false;
    const auto far = [&](auto member) {
        const auto [least, most] =
            std::minmax_element(zone.polygon[0].begin(), zone.polygon[0].end(),
                                [member](const Point& a, const Point& b) { return a.*member < b.*member; });
        return p.*member < (*least).*member || p.*member > (*most).*member;
    };
    if (far(&Point::x) || far(&Point::y)) return false;
    for (std::size_t ring = 0; ring < zone.polygon.size(); ++ring) {
        double round = 0;
        const std::vector<Point>& corners = zone.polygon[ring];
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const Point a = corners[i];
            const Point b = corners[(i + 1) % corners.size()];
            on_edge = on_edge || away_from(p, a, b) < 1e-9;
            const double cross = (a.x - p.x) * (b.y - p.y) - (a.y - p.y) * (b.x - p.x);
            const double dot = (a.x - p.x) * (b.x - p.x) + (a.y - p.y) * (b.y - p.y);
            round += std::atan2(cross, dot);
        }
        turned += ring == 0 ? std::abs(round) : -std::abs(round);
    }
    return !on_edge && turned > 3;
}

inline bool slowly_inside(const std::vector<Zone>& zones, Point p) {
    return std::any_of(zones.begin(), zones.end(), [p](const Zone& zone) { return slowly_inside(zone, p); });
}

// Whether a spot of a segment is closed: inside a zone, or with zones on both sides.
inline bool slowly_closed(const std::vector<Zone>& zones, Point p, Point a, Point b) {
    if (slowly_inside(zones, p)) return true;
    const double length = distance(a, b);
    const double nx = -(b.y - a.y) / length * 1e-6;
    const double ny = (b.x - a.x) / length * 1e-6;
    return slowly_inside(zones, {p.x + nx, p.y + ny}) && slowly_inside(zones, {p.x - nx, p.y - ny});
}

// Divided where its line meets those of the edges.
inline bool slowly_clear(const std::vector<Zone>& zones, Point a, Point b) {
    if (a == b) return true;
    std::vector<double> shares{0, 1};
    const double dx = b.x - a.x;
    const double dy = b.y - a.y;
    const auto add = [&](double share) {
        if (share > 0 && share < 1) shares.push_back(share);
    };
    for (const Zone& zone : zones) {
        for_each_edge(zone, [&](Point c, Point d) {
            const double across = dx * (d.y - c.y) - dy * (d.x - c.x);
            if (across != 0) add(((c.x - a.x) * (d.y - c.y) - (c.y - a.y) * (d.x - c.x)) / across);
            add(((c.x - a.x) * dx + (c.y - a.y) * dy) / (dx * dx + dy * dy));
        });
    }
    std::sort(shares.begin(), shares.end());
    for (std::size_t i = 1; i < shares.size(); ++i) {
        if (shares[i] - shares[i - 1] < 1e-10) continue;
        const double share = (shares[i] + shares[i - 1]) / 2;
        if (slowly_closed(zones, {a.x + share * dx, a.y + share * dy}, a, b)) return false;
    }
    return true;
}

// Over the visibility graph of all corners on the map, convex or not.
inline double slow_length(const std::vector<Zone>& zones, int width, int height, Point from, Point to) {
    std::vector<Point> places{from, to};
    for (const Zone& zone : zones) {
        for_each_edge(zone, [&](Point corner, Point) {
            const bool on_map =
                corner.x >= -0.5 && corner.y >= -0.5 && corner.x <= width - 0.5 && corner.y <= height - 0.5;
            if (on_map && !slowly_inside(zones, corner)) places.push_back(corner);
        });
    }
    std::vector<double> length(places.size(), std::numeric_limits<double>::infinity());
    std::vector<bool> done(places.size(), false);
    length[0] = 0;
    for (;;) {
        std::size_t at = places.size();
        for (std::size_t i = 0; i < places.size(); ++i) {
            if (!done[i] && std::isfinite(length[i]) && (at == places.size() || length[i] < length[at])) at = i;
        }
        if (at == places.size() || at == 1) return length[1];
        done[at] = true;
        for (std::size_t i = 0; i < places.size(); ++i) {
            if (!done[i] && length[at] + distance(places[at], places[i]) < length[i] &&
                slowly_clear(zones, places[at], places[i]))
                length[i] = length[at] + distance(places[at], places[i]);
        }
    }
}

// Of a ring within a cell, by cutting off what lies beyond each of its sides (Sutherland and Hodgman 1974).
inline double area_within(std::vector<Point> ring, Cell cell) {
    for (int cut_at = 0; cut_at < 4; ++cut_at) {
        const auto depth = [&](Point p) {
            const double along = cut_at % 2 == 0 ? p.x - cell.x : p.y - cell.y;
            return cut_at < 2 ? along + 0.5 : 0.5 - along;
        };
        std::vector<Point> cut;
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Point a = ring[i];
            const Point b = ring[(i + 1) % ring.size()];
            if (depth(a) >= 0) cut.push_back(a);
            if ((depth(a) >= 0) == (depth(b) >= 0)) continue;
            const double share = depth(a) / (depth(a) - depth(b));
            cut.emplace_back(a.x + share * (b.x - a.x), a.y + share * (b.y - a.y));
        }
        ring = std::move(cut);
    }
    double area = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point b = ring[(i + 1) % ring.size()];
        area += (ring[i].x - cell.x) * (b.y - cell.y) - (ring[i].y - cell.y) * (b.x - cell.x);
    }
    return std::abs(area) / 2;
}

inline rc::Gen<Point> arbitrary_corner(int size) {
    return rc::gen::map(rc::gen::pair(rc::gen::inRange(-2, size + 3), rc::gen::inRange(-2, size + 3)),
                        [](std::pair<int, int> p) { return Point(p.first, p.second); });
}

// A rectangle, or corners round a point in any order of distance; with luck it is simple.
inline Zone any_zone(int size) {
    const Point centre = *arbitrary_corner(size);
    Zone zone;
    std::vector<Point>& ring = zone.polygon.emplace_back();
    if (*rc::gen::inRange(0, 3) == 0) {
        const double w = *rc::gen::inRange(1, 8);
        const double h = *rc::gen::inRange(1, 8);
        ring = {centre, {centre.x + w, centre.y}, {centre.x + w, centre.y + h}, {centre.x, centre.y + h}};
        return zone;
    }
    const int corners = *rc::gen::inRange(3, 11);
    for (int i = 0; i < corners; ++i) {
        const double angle = 6.283185307179586 * (i + *rc::gen::inRange(0, 9) / 10.0) / corners;
        const double radius = *rc::gen::inRange(1, 10);
        ring.emplace_back(std::round(centre.x + radius * std::cos(angle)),
                          std::round(centre.y + radius * std::sin(angle)));
    }
    return zone;
}

inline bool is_valid(const Zone& zone) {
    try {
        validate(zone, 1);
        return true;
    } catch (const InputError&) {
        return false;
    }
}

inline std::vector<Zone> any_zones(int most, int size) {
    std::vector<Zone> zones;
    const int count = *rc::gen::inRange(0, most + 1);
    for (int i = 0; i < count; ++i) {
        Zone zone = any_zone(size);
        if (is_valid(zone)) zones.push_back(std::move(zone));
    }
    return zones;
}

inline Point any_cell(int size) {
    return Point(*rc::gen::inRange(0, size), *rc::gen::inRange(0, size));
}

}  // namespace waybreaker
