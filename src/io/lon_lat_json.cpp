#include "io/lon_lat_json.hpp"

#include <algorithm>
#include <cmath>

#include "io/antimeridian.hpp"

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

LonLat rounded(const site::ToLonLat& to_lon_lat, Point point) {
    constexpr double decimals = 1e9;
    const auto [lon, lat] = to_lon_lat(point);
    return {std::round(lon * decimals) / decimals, std::round(lat * decimals) / decimals};
}

LonLatPolygon placed(const site::ToLonLat& to_lon_lat, const site::Polygon& polygon) {
    LonLatPolygon rings;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const bool outer = i == 0;
        std::vector<LonLat>& ring = rings.emplace_back();
        for (const Point& point : polygon[i]) ring.push_back(rounded(to_lon_lat, point));
        if ((turn(polygon[i]) > 0) != outer) std::reverse(ring.begin(), ring.end());
    }
    return rings;
}

}  // namespace

Json position_json(const site::ToLonLat& to_lon_lat, Point point) {
    return rounded(to_lon_lat, point);
}

LineJson line_json(const site::ToLonLat& to_lon_lat, const std::vector<Waypoint>& path) {
    TimedLine line;
    for (const Waypoint& point : path) {
        line.places.push_back(rounded(to_lon_lat, {point.x, point.y}));
        line.times.push_back(point.t);
    }
    // An agent that does not move still has a line, of zero length.
    if (path.size() == 1) {
        line.places.push_back(line.places.front());
        line.times.push_back(line.times.front());
    }
    const std::vector<TimedLine> parts = cut_line(line);
    LineJson json{.geometry = {{"type", "LineString"}, {"coordinates", parts[0].places}}, .times = Json::array()};
    if (parts.size() > 1) {
        json.geometry = {{"type", "MultiLineString"}, {"coordinates", Json::array()}};
        for (const TimedLine& part : parts) json.geometry["coordinates"].push_back(part.places);
    }
    for (const TimedLine& part : parts) {
        for (const double time : part.times) json.times.push_back(time);
    }
    return json;
}

Json polygons_json(const site::ToLonLat& to_lon_lat, const std::vector<site::Polygon>& polygons) {
    std::vector<LonLatPolygon> parts;
    for (const site::Polygon& polygon : polygons) {
        for (LonLatPolygon& part : cut_polygon(placed(to_lon_lat, polygon))) parts.push_back(std::move(part));
    }
    if (parts.size() == 1) return {{"type", "Polygon"}, {"coordinates", std::move(parts[0])}};
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
