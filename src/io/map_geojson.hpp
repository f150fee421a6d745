// Maps as GeoJSON (RFC 7946): each obstacle a polygon of its cells. `waybreaker import` reads it back: properties have
// the names of what its options ask for.
#pragma once

#include <string>

#include "io/map_file.hpp"

namespace waybreaker::io {

// Properties: `obstacle` (its number), `osm_id` (its id in the source, where it is known), `name` (likewise), `cells`,
// `protected` (yes or no), `weight`, `breach_time`. Throws InputError if the map does not say where it lies on earth.
std::string map_geojson(const MapFile& map, const site::ToLonLat& to_lon_lat);

}  // namespace waybreaker::io
