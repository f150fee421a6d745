// Small random missions with zones that hold for a time.
#pragma once

#include <rapidcheck.h>

#include <limits>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "mission/any_world.hpp"
#include "waybreaker/plan.hpp"
#include "zones/slow_zones.hpp"

namespace waybreaker::windowed {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

// Polygons with corners at centres, sides and corners of cells, for times in which agents come by.
inline std::vector<Zone> small_zones(const Map& map) {
    std::vector<Zone> zones;
    const int count = *number(1, 3);
    for (int i = 0; i < count; ++i) {
        Zone zone{.kind = *rc::gen::element(ZoneKind::no_fly, ZoneKind::keep_out)};
        std::vector<Point>& ring = zone.polygon.emplace_back();
        const int corners = *number(3, 5);
        for (int k = 0; k < corners; ++k)
            ring.emplace_back(*number(-2, 2 * map.width()) / 2.0, *number(-2, 2 * map.height()) / 2.0);
        zone.from = *rc::gen::element(0.0, 0.0, 0.7, 2.0, 4.0, 9.5);
        zone.until = *rc::gen::element(infinity, zone.from + 0.6, zone.from + 3, zone.from + 8);
        if (is_valid(zone)) zones.push_back(std::move(zone));
    }
    return zones;
}

inline World any_windowed_world() {
    World world = any_world();
    world.mission.rules.zones = small_zones(world.map);
    return world;
}

inline std::string text(const Mission& mission) {
    std::ostringstream out;
    for (const Zone& zone : mission.rules.zones) {
        out << to_string(zone.kind) << " from " << zone.from << " until " << zone.until << ":";
        for (const Point p : zone.polygon.front()) out << " " << p.x << "," << p.y;
        out << "\n";
    }
    return out.str();
}

// Many places on the outline of a zone, as far as it is on the map.
inline std::vector<Point> outline(const Zone& zone, int size) {
    constexpr int parts = 64;
    std::vector<Point> all;
    for_each_edge(zone, [&](Point a, Point b) {
        for (int i = 0; i <= parts; ++i) {
            const double share = double(i) / parts;
            const Point p(a.x + share * (b.x - a.x), a.y + share * (b.y - a.y));
            if (p.x >= -0.5 && p.y >= -0.5 && p.x <= size - 0.5 && p.y <= size - 0.5) all.push_back(p);
        }
    });
    return all;
}

inline double reached(const Plan& plan, const Mission& mission) {
    return value(plan.after, mission.rules.objective).value_or(infinity);
}

}  // namespace waybreaker::windowed
