// Shapes painted on the cells of a window (GDAL).
#pragma once

#include <ogr_geometry.h>

#include <cstdint>
#include <vector>

#include "city/import_window.hpp"

namespace waybreaker::city {

struct Paint {
    const OGRGeometry* shape;
    std::uint32_t label;
};

// Which cells a shape paints: those whose centre it covers, or all that it touches.
enum class Cover { centre, touched };

// Paints shapes one after the other, so that the last one wins a cell, on labels of width * height cells, row by row.
// Throws InputError if GDAL fails.
void paint(const std::vector<Paint>& paints, Cover cover, const CellWindow& window, std::vector<std::uint32_t>& labels);

}  // namespace waybreaker::city
