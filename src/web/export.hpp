// Plans in other formats, by what the map document knows.
#pragma once

#include <string>

#include "io/map_document.hpp"
#include "io/plan_file.hpp"

namespace waybreaker::web {

// "json", "geojson", "csv", "svg" or "reach". Positions in longitude and latitude are those of the map's `to_lon_lat`.
// Throws InputError if the plan does not fit the map, or the format is none of these.
std::string exported(const io::DocumentedMap& map, const std::string& plan, const std::string& format);

}  // namespace waybreaker::web
