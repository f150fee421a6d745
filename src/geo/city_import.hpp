// Import: building polygons of any vector source GDAL knows, rasterised into a label map.
#pragma once

#include <cstddef>
#include <string>

#include "geo/label_tiff.hpp"

namespace waybreaker::geo {

struct ImportOptions {
    double longitude = 0;  // of the window's centre, WGS84 degrees
    double latitude = 0;
    double size = 1202.4;         // side of the square window, in metres, rounded to whole cells: 501, as in the paper
    double cell = 2.4;            // side of a cell, in metres
    bool merge_touching = false;  // obstacles are 4-connected components (the paper) instead of one per building
};

struct ImportReport {
    LabelTiff tiff;
    std::size_t buildings = 0;  // that have some area inside the window; those that own no cell are no obstacle
    double area = 0;            // of their parts inside the window, in square metres; overlaps count twice
};

// Buildings become obstacles, one each unless merged, with their source ids (OSM ways positive, relations negative);
// projected to the local UTM zone. A cell belongs to the building that covers its centre; the first in the source's
// order where several do. Throws InputError (source and remedy) if there is nothing to import.
ImportReport import_city(const std::string& source, const ImportOptions& options);

}  // namespace waybreaker::geo
