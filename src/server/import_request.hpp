// What a client asks to import, as JSON: the options of `waybreaker import` under their names, with `_` for `-`.
//
//     {"source": "source-8a1f0c92be1d44f7", "center": [7.4197, 43.7311], "size": 600, "profile": "truck"}
#pragma once

#include <string>
#include <string_view>

#include "geo/city_import.hpp"
#include "server/map_store.hpp"
#include "server/source_store.hpp"
#include "waybreaker/limits.hpp"

namespace waybreaker::server {

struct ImportRequest {
    std::string source;
    bool placed = false;  // whether it says where; else the window is the source's densest
    bool sized = false;
    geo::ImportOptions options;
};

// Throws InputError that says where and what is wrong.
ImportRequest parse_import_request(std::string_view bytes, const std::string& name = "import");

// The map, with what the user should know as its notes. Throws Problem if the source has no such map, it would be too
// large, or a stop comes before it is made.
StoredMap imported_map(const StoredSource& source, const ImportRequest& request, const MapLimits& limits,
                       const StopToken& stop);

}  // namespace waybreaker::server
