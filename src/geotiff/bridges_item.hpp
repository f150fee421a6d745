// The open cells of a label map that bridges carry, as a metadata item of its GeoTIFF, WAYBREAKER_BRIDGES: a line with
// the map's western and northern edge and the side of a cell, in its coordinate system, and a line for each run of
// cells, of its column, row and length. The first line keeps them in place when gdal_translate cuts a piece out.
//
//     457264.5 5460412.8 2.4
//     12 40 17
#pragma once

#include <array>
#include <string>
#include <vector>

#include "site/cell_run.hpp"

class GDALDataset;

namespace waybreaker::geotiff {

inline constexpr const char* bridges_item = "WAYBREAKER_BRIDGES";

// Empty if there are none. `transform` is that of the map (site/georeference.hpp).
std::string bridges_text(const std::vector<site::CellRun>& bridges, const std::array<double, 6>& transform);

// What a file says, in cells of a map of width x height that lies there; none if its cells are no longer those that the
// item counts. Throws InputError if it cannot be understood; `name` is how the file is called in errors.
std::vector<site::CellRun> read_bridges(GDALDataset& file, const std::array<double, 6>& transform, int width,
                                        int height, const std::string& name);

}  // namespace waybreaker::geotiff
