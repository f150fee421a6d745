// Routes that make maps from map data: sources that are sent, imports from them.
#pragma once

#include <vector>

#include "service/route.hpp"
#include "service/source_store.hpp"

namespace waybreaker::service {

// The handlers keep the references.
std::vector<Route> import_routes(const Importer& importer, SourceStore& sources, MapStore& maps);

}  // namespace waybreaker::service
