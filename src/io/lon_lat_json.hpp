// Places in GeoJSON: what is in cells, in longitude and latitude.
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "site/georeference.hpp"
#include "site/outline.hpp"
#include "waybreaker/plan.hpp"

namespace waybreaker::io {

// [longitude, latitude] with 9 decimals.
nlohmann::ordered_json position_json(const site::ToLonLat& to_lon_lat, Point point);

// A LineString, or a MultiLineString if it crosses 180 degrees, and the time at each of its positions: of several lines
// one after the other.
struct LineJson {
    nlohmann::ordered_json geometry;
    nlohmann::ordered_json times;
};
LineJson line_json(const site::ToLonLat& to_lon_lat, const std::vector<Waypoint>& path);

// A Polygon or a MultiPolygon; outer rings run counterclockwise and 180 degrees cut, as RFC 7946 asks.
nlohmann::ordered_json polygons_json(const site::ToLonLat& to_lon_lat, const std::vector<site::Polygon>& polygons);

// A FeatureCollection, a feature a line. `head` is an object of members to go before the features.
std::string collection_text(const nlohmann::ordered_json& head, const std::vector<nlohmann::ordered_json>& features);

}  // namespace waybreaker::io
