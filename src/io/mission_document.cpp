#include "io/mission_document.hpp"

#include <utility>

#include "io/place_reason.hpp"
#include "io/tagged_obstacles.hpp"
#include "io/weights.hpp"
#include "waybreaker/error.hpp"
#include "waybreaker/place_error.hpp"

namespace waybreaker::io {

double usual_radius(const MapFile& file) {
    return site::body_radius(file.has_metres() ? file.annotations.profile : std::nullopt, file.cell_size);
}

bool size_agents(MissionDocument& document, const MapFile& file) {
    const double radius = usual_radius(file);
    bool sized = false;
    for (const std::size_t index : std::exchange(document.unsized, {})) {
        Body& body = document.mission.agents[index].body;
        if (body.corners != Corners::none || body.radius == radius) continue;
        body.radius = radius;
        sized = true;
    }
    return sized;
}

std::optional<Map> resolve(MissionDocument& document, const MapFile& file,
                           const std::optional<std::vector<double>>& weights) {
    if (document.overlays != file.overlays) {
        if (document.overlays.empty())
            throw InputError(file.source + " has overlays laid over it, which the mission is not for");
        throw InputError("the mission is for a map with " + document.overlays.front().file +
                         " laid over it: lay it over the map first, as 'waybreaker map overlay' does, and leave out "
                         "'overlays'");
    }
    add_tagged(file, std::exchange(document.protect_tags, {}), "protect", document.mission.rules.protect);
    for (const auto& [agent, tags] : std::exchange(document.can_breach_tags, {}))
        add_tagged(file, tags, "breach", *document.mission.agents[agent].can_breach->only);
    if (document.area_budget) return file.map.with_weights(area_weights(file));
    if (weights) return file.map.with_weights(*weights);
    return std::nullopt;
}

std::optional<Map> settle(MissionDocument& document, const MapFile& file,
                          const std::optional<std::vector<double>>& weights) {
    size_agents(document, file);
    document.method.planner = planner_of(document.method, document.mission.ground_body());
    return resolve(document, file, weights);
}

void validate_on(const MapFile& file, const MissionDocument& document) try {
    validate(file.map, document.mission, document.method, document.limits);
} catch (const PlaceError& error) {
    Misplaced agent = error.misplaced;
    agent.reason = place_reason(agent, file);
    throw PlaceError(std::move(agent));
}

}  // namespace waybreaker::io
