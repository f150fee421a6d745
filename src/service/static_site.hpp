// The page and its maps as files that any host of files serves: what the service answers before it plans. The page
// brings its own planner along.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace waybreaker::service {

struct SiteFile {
    std::string path;  // below the folder
    std::string bytes;
};

// Of a folder of maps, beside those that are built in; it may be empty. `wasm` is the planner (src/web). `begin` is
// called with the name of each map before it is read. The same input gives the same files. Throws InputError that names
// the map that cannot be read.
std::vector<SiteFile> static_site(const std::string& maps, std::string_view wasm,
                                  const std::function<void(const std::string& map)>& begin = {});

}  // namespace waybreaker::service
