// Files as the editor JOSM saves them: objects that were deleted and not yet uploaded are in them, marked
// action="delete", which libosmium passes over.
#pragma once

#include <cstdint>
#include <osmium/osm/item_type.hpp>
#include <set>
#include <string>
#include <utility>

namespace waybreaker::osm {

using Deleted = std::set<std::pair<osmium::item_type, std::int64_t>>;

// Nodes, ways and relations of XML, plain or by gzip, that are marked as deleted. Where the file is damaged, those
// before it: who reads the objects says so.
Deleted marked_as_deleted(const std::string& path);

}  // namespace waybreaker::osm
