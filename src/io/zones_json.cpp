#include "io/zones_json.hpp"

#include <cmath>

#include "io/mission_json.hpp"
#include "io/option_words.hpp"

namespace waybreaker::io {
namespace {

using Json = nlohmann::ordered_json;

constexpr auto cells = "cells";
constexpr double per_degree = 1e7;  // a centimetre

std::vector<Point> read_ring(const JsonField& field) {
    std::vector<Point> ring;
    for (const JsonField& position : field.items()) ring.push_back(read_position(position));
    if (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
    return ring;
}

std::vector<std::vector<Point>> read_polygon(const JsonField& field) {
    std::vector<std::vector<Point>> rings;
    for (const JsonField& ring : field.items()) rings.push_back(read_ring(ring));
    return rings;
}

void add_zones(const JsonField& feature, std::vector<Zone>& zones) {
    feature["type"].one_of<bool>({{"Feature", true}});
    const JsonField properties = feature["properties"];
    Zone zone;
    zone.kind = properties["zone"].one_of(zone_words);
    if (const auto name = properties.find("name")) zone.name = name->text();
    if (const auto agents = properties.find("agents")) {
        for (const JsonField& id : agents->items()) zone.agents.push_back(read_agent_id(id));
        if (zone.agents.empty()) agents->fail("names nobody; leave it out for a zone that holds for all");
    }
    if (const auto from = properties.find("from")) zone.from = from->number();
    if (const auto until = properties.find("until")) zone.until = until->number();
    const JsonField geometry = feature["geometry"];
    const bool several = geometry["type"].one_of<bool>({{"Polygon", false}, {"MultiPolygon", true}});
    const JsonField coordinates = geometry["coordinates"];
    if (!several) {
        zone.polygon = read_polygon(coordinates);
        zones.push_back(std::move(zone));
        return;
    }
    for (const JsonField& polygon : coordinates.items()) {
        zones.push_back(zone);
        zones.back().polygon = read_polygon(polygon);
    }
}

}  // namespace

// Older GeoJSON has an object, which names a system of coordinates.
bool is_in_cells(const JsonField& collection) {
    const auto crs = collection.find("crs");
    if (!crs) return false;
    if (crs->json() == cells) return true;
    if (crs->json().is_object() && crs->json().dump().find("CRS84") != std::string::npos) return false;
    crs->fail("is neither cells nor longitude and latitude, which GeoJSON has where it says nothing");
}

Point read_position(const JsonField& field) {
    const std::vector<JsonField> parts = field.items();
    if (parts.size() < 2) field.fail("is no position, [x, y]");
    return {parts[0].number(), parts[1].number()};
}

ZoneCollection read_zones(const JsonField& collection) {
    collection["type"].one_of<bool>({{"FeatureCollection", true}});
    ZoneCollection result;
    result.in_cells = is_in_cells(collection);
    for (const JsonField& feature : collection["features"].items()) add_zones(feature, result.zones);
    return result;
}

ZoneCollection parse_zones(std::string_view bytes, const std::string& name) {
    const auto document = parse_json(bytes, name, max_mission_depth);
    return read_zones(JsonField(document));
}

Json zones_json(const std::vector<Zone>& zones, const site::ToLonLat& to_lon_lat) {
    const auto position = [&](Point p) -> Json {
        if (!to_lon_lat) return {p.x, p.y};
        const auto [longitude, latitude] = to_lon_lat(p);
        return {std::round(longitude * per_degree) / per_degree, std::round(latitude * per_degree) / per_degree};
    };
    Json features = Json::array();
    for (const Zone& zone : zones) {
        Json properties{{"zone", to_string(zone.kind)}};
        if (!zone.name.empty()) properties["name"] = zone.name;
        if (!zone.agents.empty()) properties["agents"] = zone.agents;
        if (zone.from > 0) properties["from"] = zone.from;
        if (std::isfinite(zone.until)) properties["until"] = zone.until;
        Json rings = Json::array();
        for (const std::vector<Point>& ring : zone.polygon) {
            Json positions = Json::array();
            for (const Point p : ring) positions.push_back(position(p));
            if (!ring.empty()) positions.push_back(position(ring.front()));
            rings.push_back(std::move(positions));
        }
        features.push_back({{"type", "Feature"},
                            {"properties", std::move(properties)},
                            {"geometry", {{"type", "Polygon"}, {"coordinates", std::move(rings)}}}});
    }
    Json collection{{"type", "FeatureCollection"}};
    if (!to_lon_lat) collection["crs"] = cells;
    collection["features"] = std::move(features);
    return collection;
}

}  // namespace waybreaker::io
