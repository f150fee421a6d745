// Plans as GeoJSON (RFC 7946), for GIS.
//
// Features have a property `role`: `path` (a line, with the time at each of its points), `breach` (a point, where the
// air agent opens an obstacle) and `removed` (the obstacle's cells as polygons, with its id in the source and its
// name). Times are in their `time_unit`; `speed` is in cells per unit of it, and `speed_m_s` says the same in metres
// per second where that is known. Longitude and latitude have 9 decimals, a tenth of a millimetre.
#pragma once

#include <string>

#include "io/export_units.hpp"
#include "io/map_file.hpp"
#include "waybreaker/plan.hpp"

namespace waybreaker::io {

// Precondition: the plan is one for this map. Throws InputError if the map does not say where it lies on earth.
std::string plan_geojson(const Plan& plan, const MapFile& map, const site::ToLonLat& to_lon_lat,
                         const ExportUnits& units = {});

}  // namespace waybreaker::io
