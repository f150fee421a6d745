#include "io/plan_geojson.hpp"

#include "io/lon_lat_json.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::io {
namespace {

using Json = nlohmann::ordered_json;

Json feature(Json properties, Json geometry) {
    return {{"type", "Feature"}, {"properties", std::move(properties)}, {"geometry", std::move(geometry)}};
}

Json path_feature(const site::ToLonLat& to_lon_lat, const Itinerary& agent, const MapFile& map,
                  const ExportUnits& units) {
    const char* const kind = agent.kind == AgentKind::ground ? "ground" : "air";
    Json properties{{"role", "path"}, {"agent", agent.id}, {"kind", kind}, {"speed", agent.speed}};
    if (units.in_seconds && map.has_metres()) properties["speed_m_s"] = agent.speed * map.cell_size;
    properties["time_unit"] = time_unit(units);
    properties["arrives_at"] = agent.reached ? Json(agent.path.back().t) : Json();
    LineJson line = line_json(to_lon_lat, agent.path);
    properties["times"] = std::move(line.times);
    return feature(std::move(properties), std::move(line.geometry));
}

Json properties_of(const Breach& breach, const MapFile& map, const ExportUnits& units, const char* role,
                   std::size_t order) {
    Json properties{{"role", role}, {"order", order}, {"obstacle", breach.obstacle.value}};
    properties["source_id"] = breach.source_id != 0 ? Json(breach.source_id) : Json();
    if (const std::string_view name = map.annotations.name_of(breach.obstacle); !name.empty())
        properties["name"] = name;
    properties["cells"] = breach.cells;
    if (map.has_metres()) properties["area_m2"] = map.square_metres(breach.cells);
    if (!breach.by.empty()) properties["by"] = breach.by;
    properties["time_unit"] = time_unit(units);
    if (breach.begun_at) properties["begun_at"] = *breach.begun_at;
    properties["cleared_at"] = breach.cleared_at;
    properties["entered_at"] = breach.entered_at ? Json(*breach.entered_at) : Json();
    return properties;
}

}  // namespace

std::string plan_geojson(const Plan& plan, const MapFile& map, const site::ToLonLat& to_lon_lat,
                         const ExportUnits& units) {
    if (!to_lon_lat) {
        throw InputError(map.source +
                         ": GeoJSON needs longitude and latitude, but the map does not say where it lies on earth; "
                         "CSV and ROS paths do without");
    }
    std::vector<Json> features;
    for (std::size_t i = 0; i < plan.breaches.size(); ++i) {
        const Breach& breach = plan.breaches[i];
        features.push_back(feature(properties_of(breach, map, units, "removed", i + 1),
                                   polygons_json(to_lon_lat, site::outline(map.map, breach.obstacle))));
    }
    for (const Itinerary& agent : plan.agents) features.push_back(path_feature(to_lon_lat, agent, map, units));
    for (std::size_t i = 0; i < plan.breaches.size(); ++i) {
        const Json place{{"type", "Point"}, {"coordinates", position_json(to_lon_lat, plan.breaches[i].at)}};
        features.push_back(feature(properties_of(plan.breaches[i], map, units, "breach", i + 1), place));
    }
    Json head = Json::object();
    if (!map.annotations.title.empty()) head["title"] = map.annotations.title;
    if (!map.annotations.attribution.empty()) head["attribution"] = map.annotations.attribution;
    return collection_text(head, features);
}

}  // namespace waybreaker::io
