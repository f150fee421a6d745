// Where the cells of a raster lie, and how large they are on the ground.
#pragma once

#include <gdal_priv.h>

#include <array>
#include <optional>
#include <string>

#include "site/georeference.hpp"

namespace waybreaker::geotiff {

struct RasterPlace {
    double cell_size = 1;  // metres
    // Where the file's coordinate system leads to longitudes and latitudes.
    std::optional<site::Georeference> georeference = {};
    // Else the lower-left corner, in the metres of the file's own coordinates.
    std::optional<std::array<double, 2>> origin = {};
};

// Throws InputError (name and remedy) unless cells are square and north-up, and lengths in the coordinate system are
// those on the ground: in degrees they are not, nor in Web Mercator.
RasterPlace read_place(GDALDataset& file, const std::string& name);
// Has a file lie there.
void write_place(GDALDataset& file, const RasterPlace& place);

}  // namespace waybreaker::geotiff
