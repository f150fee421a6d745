#include "io/map_geojson.hpp"

#include "io/lon_lat_json.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::io {
namespace {

using Json = nlohmann::ordered_json;

Json properties_of(const Obstacle& obstacle, const MapFile& map) {
    Json properties{{"obstacle", obstacle.id.value}};
    if (obstacle.source_id != 0) properties["osm_id"] = obstacle.source_id;
    if (const std::string_view name = map.annotations.name_of(obstacle.id); !name.empty()) properties["name"] = name;
    properties["cells"] = obstacle.cells;
    properties["protected"] = obstacle.destructible ? "no" : "yes";
    properties["weight"] = obstacle.weight;
    properties["breach_time"] = obstacle.breach_time;
    return properties;
}

}  // namespace

std::string map_geojson(const MapFile& map, const site::ToLonLat& to_lon_lat) {
    if (!to_lon_lat) {
        throw InputError(map.source +
                         ": GeoJSON needs longitude and latitude, but the map does not say where it lies on earth");
    }
    const std::vector<std::vector<site::Polygon>> outlines = site::outlines(map.map);
    std::vector<Json> features;
    for (const Obstacle& obstacle : map.map.obstacles()) {
        features.push_back({{"type", "Feature"},
                            {"properties", properties_of(obstacle, map)},
                            {"geometry", polygons_json(to_lon_lat, outlines[obstacle.id.value])}});
    }
    Json head = Json::object();
    if (!map.annotations.title.empty()) head["title"] = map.annotations.title;
    if (!map.annotations.attribution.empty()) head["attribution"] = map.annotations.attribution;
    return collection_text(head, features);
}

}  // namespace waybreaker::io
