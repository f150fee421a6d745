// GeoTIFF label maps: obstacle id per cell, 0 = free, with coordinate system. The format `waybreaker import` writes.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "waybreaker/map.hpp"

namespace waybreaker::geo {

// Where the map lies on the ground.
struct Georeference {
    std::string crs;  // well-known text
    // GDAL's affine transform from cell corner coordinates (column, row) to the coordinate system.
    std::array<double, 6> transform{0, 1, 0, 0, 0, 1};
    std::string crs_name() const;  // for people, e.g. "WGS 84 / UTM zone 33N"
    std::array<double, 2> lon_lat(double x,
                                  double y) const;  // of a point in cell units (integer = cell centre), WGS84 degrees
};

struct LabelTiff {
    Map map;
    double cell_size = 1;  // metres per cell
    std::optional<Georeference> georeference;
    std::string attribution;  // of the source data; may be empty
    std::string title;        // place and window, for captions; may be empty
};

// Throws InputError (file and remedy) on anything that is not such a map, or too large for the limits of grid.hpp.
LabelTiff read_label_tiff(const std::string& path);

// Written whole or not at all. Small: compressed, labels in the least integer type.
void write_label_tiff(const std::string& path, const LabelTiff& tiff);

}  // namespace waybreaker::geo
