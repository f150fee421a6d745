// A map file whose walls have fallen or were built since.
#pragma once

#include <string>
#include <vector>

#include "io/map_file.hpp"
#include "waybreaker/map_edit.hpp"

namespace waybreaker::io {

// The map with its obstacles changed (Map::with), under the same name. Its digest is that of the map before and of the
// edits, one after the other (docs/c.md), so that it costs no look at all cells; without edits it stays. Throws what
// Map::with throws.
MapFile with_edits(MapFile file, const std::vector<MapEdit>& edits);

}  // namespace waybreaker::io
