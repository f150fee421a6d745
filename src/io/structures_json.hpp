// What sections are parts of, in the documents that name obstacles.
#pragma once

#include <nlohmann/json.hpp>

#include "site/sections.hpp"

namespace waybreaker::io {

// [{"kind": "building", "source_id": 43031400, "name": "Dom"}, ...]: the buildings, barriers and others that the
// obstacle has parts of; ids and names where they are known. Empty unless it is a section.
nlohmann::ordered_json structures_json(ObstacleId id, const site::Sections& sections);

}  // namespace waybreaker::io
