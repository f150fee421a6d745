// What a client draws on a map and erases from it, as JSON, and the map that this makes:
//
//     {"block": [[10, 4, 3]], "free": [[0, 0, 2]]}
//
// Runs of cells: x and y of the first, and how many there are, to the right. What is freed is freed first.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "server/map_shelf.hpp"

namespace waybreaker::server {

struct CellRun {
    Cell first;
    int length = 1;
};

struct MapEdits {
    std::vector<CellRun> block;
    std::vector<CellRun> free;
};

// Throws InputError: "edits: ", where in it, what is wrong. `name` is how it is called.
MapEdits parse_map_edits(std::string_view bytes, const std::string& name = "edits");

// What people know the map by stays: its obstacles and their names, place, size of cells, background. Cells that are
// drawn where they were free become obstacles, one for each 4-connected set of them, beside those of the map; but where
// the map's obstacles are no more than its connected sets of blocked cells, so are those of the edited one. Throws
// InputError if the edits do not fit the map.
ShelvedMap edited_map(const ShelvedMap& map, const MapEdits& edits, const MapLimits& limits = {});

}  // namespace waybreaker::server
