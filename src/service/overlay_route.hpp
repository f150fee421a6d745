// The route that lays vector data over a map and so makes another.
#pragma once

#include "service/importer.hpp"
#include "service/map_store.hpp"
#include "service/route.hpp"

namespace waybreaker::service {

// Keeps the references.
Route overlay_route(const Importer& importer, MapStore& maps);

}  // namespace waybreaker::service
