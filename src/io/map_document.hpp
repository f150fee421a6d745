// The map document, "waybreaker-map/1": all that is known of a map, as JSON, for programs without GDAL. Its
// description, obstacles and background are what the service answers; plans on it equal those on the map's file, to the
// byte.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "io/map_file.hpp"

namespace waybreaker::io {

// What only projections know.
struct MapPlace {
    nlohmann::ordered_json georeference = nullptr;  // as in map_info()
    std::string frame_crs = {};                     // as in ExportUnits
};

struct DocumentedMap {
    MapFile file;
    Connectivity connectivity = Connectivity::four;
    MapPlace place = {};
};

// What `GET /maps/{id}` answers.
nlohmann::ordered_json map_description(const std::string& id, const MapFile& file, Connectivity connectivity,
                                       const nlohmann::ordered_json& georeference);

std::string map_document(const std::string& id, const DocumentedMap& map);

// Throws InputError that says where and what is wrong; `name` is what errors call the document.
DocumentedMap parse_map_document(std::string_view bytes, const std::string& name);

}  // namespace waybreaker::io
