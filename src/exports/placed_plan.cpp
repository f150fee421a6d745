#include "exports/placed_plan.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "waybreaker/airspace.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::exports {

void require_place(const PlacedPlan& placed, std::string_view format) {
    if (placed.to_lon_lat) return;
    throw InputError(fmt::format(
        "{}: {} needs longitude and latitude, but the map does not say where it lies on earth: take a map of "
        "waybreaker import, or another GeoTIFF with a coordinate system; CSV and ROS paths do without",
        placed.map.source, format));
}

std::string obstacle_name(const PlacedPlan& placed, ObstacleId obstacle) {
    const std::string_view name = placed.map.annotations.name_of(obstacle);
    return name.empty() ? fmt::format("obstacle {}", obstacle.value) : std::string(name);
}

bool holds_for(const Zone& zone, const Itinerary& agent) {
    return (zone.kind == ZoneKind::no_fly) == (agent.kind == AgentKind::air) &&
           (zone.agents.empty() || std::ranges::find(zone.agents, agent.id) != zone.agents.end());
}

void require_no_hole(const PlacedPlan& placed, const Itinerary& agent, std::string_view format) {
    if (agent.path.empty()) return;
    const Map& map = placed.map.map;
    for (std::size_t i = 0; i < placed.zones.size(); ++i) {
        const Zone& zone = placed.zones[i];
        if (zone.polygon.size() == 1 || !holds_for(zone, agent)) continue;
        const Zone filled{.polygon = {zone.polygon.front()}};
        if (Airspace(std::span(&filled, 1), map.width(), map.height()).allows({agent.path[0].x, agent.path[0].y}))
            continue;
        throw InputError(
            fmt::format("{}: agent '{}' is in a hole of {}, and areas have no holes there; leave the hole out", format,
                        agent.id, name_of(zone, i + 1)));
    }
}

std::string breached_by(const Plan& plan, const Breach& breach) {
    if (!breach.by.empty()) return breach.by;
    const auto flies = [](const Itinerary& agent) { return agent.kind == AgentKind::air; };
    const auto aircraft = std::ranges::find_if(plan.agents, flies);
    return aircraft == plan.agents.end() ? "" : aircraft->id;
}

// The plan of one aircraft does not say it: the stay ends when the obstacle is gone.
double begun_at(const Plan& plan, const Breach& breach) {
    if (breach.begun_at) return *breach.begun_at;
    const std::string by = breached_by(plan, breach);
    for (const Itinerary& agent : plan.agents) {
        if (agent.kind != AgentKind::air || agent.id != by) continue;
        const Waypoint end{double(breach.at.x), double(breach.at.y), breach.cleared_at};
        for (std::size_t i = 1; i < agent.path.size(); ++i) {
            const Waypoint& before = agent.path[i - 1];
            if (agent.path[i] == end && before.x == end.x && before.y == end.y) return before.t;
        }
    }
    return breach.cleared_at;
}

}  // namespace waybreaker::exports
