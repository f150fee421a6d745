// Geofabrik's shapefiles and GeoPackages, whose attribute `fclass` says what OpenStreetMap says by tags.
// (Ramm, "OpenStreetMap Data in Layered GIS Format", version 0.7.12.)
#pragma once

#include <ogrsf_frmts.h>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace waybreaker::city {

// The key whose values a layer of theirs has, such as `highway`; empty if it is no layer of theirs, or one of no use
// here.
std::string_view geofabrik_key(OGRLayer& layer);

// The attributes of a feature in a layer of that key, and the tag of OpenStreetMap that its `fclass` stands for.
std::vector<std::pair<std::string, std::string>> geofabrik_tags(
    std::string_view key, const std::vector<std::pair<std::string, std::string>>& attributes);

}  // namespace waybreaker::city
