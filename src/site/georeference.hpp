// Where a map lies on the ground.
#pragma once

#include <array>
#include <functional>
#include <string>

#include "waybreaker/cell.hpp"

namespace waybreaker::site {

struct Georeference {
    std::string crs;  // well-known text
    // GDAL's affine transform from cell corner coordinates (column, row) to the coordinate system.
    std::array<double, 6> transform{0, 1, 0, 0, 0, 1};
};

// Longitude and latitude (WGS84, degrees) of a point in cell units (integer = cell centre). Empty if unknown: writers
// of formats that need it report that.
using ToLonLat = std::function<std::array<double, 2>(Point)>;

}  // namespace waybreaker::site
