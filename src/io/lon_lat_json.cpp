#include "io/lon_lat_json.hpp"

#include <algorithm>
#include <cmath>

namespace waybreaker::io {
namespace {

using Json = nlohmann::ordered_json;

std::string dump(const Json& json) {
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

// Twice the area, positive where the ring runs counterclockwise with y down.
double turn(const site::Ring& ring) {
    double sum = 0;
    for (std::size_t i = 1; i < ring.size(); ++i) sum += ring[i].x * ring[i - 1].y - ring[i - 1].x * ring[i].y;
    return sum;
}

Json polygon_json(const site::ToLonLat& to_lon_lat, const site::Polygon& polygon) {
    Json rings = Json::array();
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const bool outer = i == 0;
        Json ring = Json::array();
        for (const Point& point : polygon[i]) ring.push_back(position_json(to_lon_lat, point));
        if ((turn(polygon[i]) > 0) != outer) std::reverse(ring.begin(), ring.end());
        rings.push_back(std::move(ring));
    }
    return rings;
}

}  // namespace

Json position_json(const site::ToLonLat& to_lon_lat, Point point) {
    constexpr double decimals = 1e9;
    const auto [lon, lat] = to_lon_lat(point);
    return {std::round(lon * decimals) / decimals, std::round(lat * decimals) / decimals};
}

Json polygons_json(const site::ToLonLat& to_lon_lat, const std::vector<site::Polygon>& polygons) {
    if (polygons.size() == 1) return {{"type", "Polygon"}, {"coordinates", polygon_json(to_lon_lat, polygons[0])}};
    Json parts = Json::array();
    for (const site::Polygon& polygon : polygons) parts.push_back(polygon_json(to_lon_lat, polygon));
    return {{"type", "MultiPolygon"}, {"coordinates", std::move(parts)}};
}

std::string collection_text(const Json& head, const std::vector<Json>& features) {
    std::string text = "{\"type\": \"FeatureCollection\",\n";
    for (const auto& [key, value] : head.items()) text += dump(Json(key)) + ": " + dump(value) + ",\n";
    text += "\"features\": [";
    const char* separator = "\n";
    for (const Json& feature : features) {
        text += separator + dump(feature);
        separator = ",\n";
    }
    return text + "\n]}\n";
}

}  // namespace waybreaker::io
