// Zones as GeoJSON (RFC 7946): a FeatureCollection of polygons.
//
//     {"type": "FeatureCollection", "crs": "cells", "features": [
//       {"type": "Feature", "properties": {"zone": "no_fly", "name": "airport", "agents": ["air"]},
//        "geometry": {"type": "Polygon", "coordinates": [[[40, 10], [90, 10], [90, 60], [40, 60], [40, 10]]]}}]}
//
// Only "zone" must be among the properties; "from" and "until" may be, units of time; others are passed by.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "io/json_field.hpp"
#include "site/georeference.hpp"
#include "waybreaker/zone.hpp"

namespace waybreaker::io {

inline constexpr std::size_t max_zones_bytes = std::size_t{1} << 24;

struct ZoneCollection {
    std::vector<Zone> zones = {};
    bool in_cells = false;  // else corners are longitude and latitude, in degrees
};

// Whether a collection says that its coordinates are cells; else they are longitude and latitude.
bool is_in_cells(const JsonField& collection);
Point read_position(const JsonField& field);

// Throws InputError naming what is wrong and where. A MultiPolygon is a zone for each of its polygons. Whether the
// polygons are simple is not asked.
ZoneCollection read_zones(const JsonField& collection);
ZoneCollection parse_zones(std::string_view bytes, const std::string& name);

// In cells, and then it reads back as what was written; or in longitude and latitude, to a centimetre. REQUIRES: finite
// corners.
nlohmann::ordered_json zones_json(const std::vector<Zone>& zones, const site::ToLonLat& to_lon_lat = {});

}  // namespace waybreaker::io
