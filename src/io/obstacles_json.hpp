// The obstacles of a map and their cells, for programs that draw them: `GET /maps/{id}/obstacles` of the service.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "io/map_file.hpp"

namespace waybreaker::io {

// {"width": 501, "height": 501, "obstacles": [{"id": 1, "source_id": 43031400, "name": "", "cells": 2357,
//   "bounds": [xmin, ymin, xmax, ymax], "destructible": true, "weight": 1.0, "breach_time": 0.0}, ...], "runs": [...],
//   "next": null}
// An obstacle has "kind", "tags" (["amenity=school", ...]) and "structures" (structures_json.hpp) where the map knows.
// `runs` are the labels of all cells, [label, length, label, length, ...], row after row; 0 is free.
std::string obstacles_json(const MapFile& file);

// A part of that document: the runs from a cell on, counted row by row, with the obstacles that begin in them; so parts
// make the whole when their lists are joined. At most so many obstacles, and ten times so many runs. `next` is the cell
// at which the next part begins.
struct ObstaclesPart {
    std::string json;
    std::optional<std::size_t> next;
};
ObstaclesPart obstacles_part(const MapFile& file, std::size_t first_cell, std::size_t most_obstacles);

}  // namespace waybreaker::io
