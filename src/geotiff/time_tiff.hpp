// GeoTIFF of times, a number for each cell: for programs of GIS, which classify and colour them.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "site/georeference.hpp"

namespace waybreaker::geotiff {

// A time for each cell, row by row; infinity where there is none.
struct TimeBand {
    std::string name;
    std::span<const float> times;
};

struct TimeTiff {
    int width = 0;  // cells
    int height = 0;
    // Where they lie, as in LabelTiff.
    double cell_size = 1;
    std::optional<site::Georeference> georeference = {};
    std::optional<std::array<double, 2>> origin = {};
    std::vector<TimeBand> bands = {};
};

// The bytes of a GeoTIFF of 32-bit floating point numbers. Where there is no time, they are the no-data value -1.
std::string time_tiff_bytes(const TimeTiff& tiff);

}  // namespace waybreaker::geotiff
