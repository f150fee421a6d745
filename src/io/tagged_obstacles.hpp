// Obstacles by what they are or are called: people know hospitals, not their numbers.
#pragma once

#include <string>
#include <vector>

#include "io/map_file.hpp"
#include "site/tag_filter.hpp"
#include "waybreaker/mission.hpp"

namespace waybreaker::io {

// The obstacles that match the filter, ascending: by the tags that the map keeps of them, with the key `name` by what
// they are called. A section matches if anything does that it is a part of.
std::vector<ObstacleId> tagged_obstacles(const MapFile& map, const site::TagFilter& filter);

// Adds what matches any of the filters to the ids, which are then ascending, each once. Throws InputError, saying what
// the map has instead, if no obstacle matches one of them: "nothing to protect: ...", for that purpose.
void add_tagged(const MapFile& map, const std::vector<site::TagFilter>& filters, const std::string& purpose,
                std::vector<ObstacleId>& ids);

}  // namespace waybreaker::io
