// A map as a client has edited it, as a file.
#pragma once

#include "request/map_edits.hpp"
#include "service/map_store.hpp"

namespace waybreaker::service {

// As request::edited_map, and equal to an upload of its file.
StoredMap edited_map(const StoredMap& map, const request::MapEdits& edits, const MapLimits& limits = {});

}  // namespace waybreaker::service
