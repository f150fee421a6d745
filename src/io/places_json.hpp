// Places as GeoJSON (RFC 7946): a FeatureCollection of points.
//
//     {"type": "FeatureCollection", "features": [
//       {"type": "Feature", "properties": {"name": "Invalidenstrasse 5", "weight": 40},
//        "geometry": {"type": "Point", "coordinates": [13.3777, 52.5305]}}]}
//
// "name" and "weight" may be left out; other properties are passed by.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "io/json_field.hpp"
#include "waybreaker/cell.hpp"

namespace waybreaker::io {

inline constexpr std::size_t max_places_bytes = std::size_t{1} << 24;

struct Place {
    Point at = {};
    std::string name = {};
    double weight = 1;  // as of an agent
};

struct PlaceCollection {
    std::vector<Place> places = {};
    bool in_cells = false;  // else they are longitude and latitude, in degrees
};

// Throws InputError naming what is wrong and where.
PlaceCollection parse_places(std::string_view bytes, const std::string& name);

}  // namespace waybreaker::io
