// The obstacles of a map and their cells, for programs that draw them: `GET /maps/{id}/obstacles` of the service.
#pragma once

#include <string>

#include "io/map_file.hpp"

namespace waybreaker::io {

// {"width": 501, "height": 501, "obstacles": [{"id": 1, "source_id": 43031400, "name": "", "cells": 2357,
//   "bounds": [xmin, ymin, xmax, ymax], "destructible": true, "weight": 1.0, "breach_time": 0.0}, ...], "runs": [...]}
// `runs` are the labels of all cells, [label, length, label, length, ...], row after row; 0 is free.
std::string obstacles_json(const MapFile& file);

}  // namespace waybreaker::io
