#include "io/plan_surfaces.hpp"

#include <algorithm>

namespace waybreaker::io {

std::vector<std::optional<site::Surface>> plan_surfaces(const Plan& plan, const MapFile& map) {
    std::vector<std::optional<site::Surface>> surfaces(plan.agents.size());
    if (map.annotations.ways.empty() || !map.has_metres()) return surfaces;
    const site::SurfaceMap ground(map.map, map.annotations, map.cell_size);
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
        const Itinerary& agent = plan.agents[i];
        if (agent.kind != AgentKind::ground) continue;
        std::vector<Point> path;
        for (const Waypoint& at : agent.path) path.emplace_back(at.x, at.y);
        surfaces[i] = ground.along(path);
    }
    return surfaces;
}

std::string surface_line(const Plan& plan, const Mission& mission, const MapFile& map) {
    std::optional<site::Surface> all;
    for (const std::optional<site::Surface>& one : plan_surfaces(plan, map)) {
        if (!one) continue;
        if (!all) all.emplace();
        *all += *one;
    }
    if (!all) return "";
    const bool is_one = std::ranges::count(mission.agents, AgentKind::ground, &Agent::kind) == 1;
    return std::string(is_one ? "ground agent" : "all vehicles") + ": " + site::surface_text(*all, map.cell_size);
}

}  // namespace waybreaker::io
