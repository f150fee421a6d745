// Who the obstacles of a label map are, as metadata items of its GeoTIFF: lists in id order, with commas between.
//
//     WAYBREAKER_OBSTACLES     source ids, `!` before one that cannot be destroyed
//     WAYBREAKER_WEIGHTS       what each counts for against a budget
//     WAYBREAKER_BREACH_TIMES  how long the breach of each takes
//
// An item is left out if all its values are the default.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "labels/metadata_items.hpp"
#include "waybreaker/map.hpp"

namespace waybreaker::labels {

// Items and their texts.
std::vector<std::pair<const char*, std::string>> obstacle_metadata(const Map& map);

// What a file says, by label; only entry 0 if it says nothing. `name` is what errors call the file.
std::vector<ObstacleAttributes> read_obstacle_metadata(const MetadataItems& items, const std::string& name);

}  // namespace waybreaker::labels
