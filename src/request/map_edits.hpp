// What a client draws on a map and erases from it, as JSON, and the edited map:
//
//     {"block": [[10, 4, 3]], "free": [[0, 0, 2]]}
//
// Runs of cells: x and y of the first, and the number of cells to the right. Cells are freed before others are blocked.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "io/map_file.hpp"
#include "site/cell_run.hpp"

namespace waybreaker::request {

using site::CellRun;

struct MapEdits {
    std::vector<CellRun> block;
    std::vector<CellRun> free;
};

// Throws InputError that says where and what is wrong; `name` is what errors call the input.
MapEdits parse_map_edits(std::string_view bytes, const std::string& name = "edits");

struct EditedMap {
    io::MapFile file;    // without a digest
    bool plain = false;  // its obstacles are just the connected sets of blocked cells
};

// Keeps the obstacles and their names, the georeference, the cell size and the background. Free cells that are drawn on
// become new obstacles, one for each 4-connected set; but if the map's obstacles are just its connected sets of blocked
// cells, so are those of the edited map. Throws InputError if the edits do not fit the map.
EditedMap edited_map(const io::MapFile& file, Connectivity connectivity, const MapEdits& edits);

}  // namespace waybreaker::request
