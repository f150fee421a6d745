// The numbers in a raster's cells, as ids of obstacles.
#pragma once

#include <gdal_priv.h>

#include <cstdint>
#include <string>
#include <vector>

#include "geotiff/gdal_scope.hpp"

namespace waybreaker::geotiff {

// Throws InputError (name and remedy) unless it is one band of integers of up to 32 bits, and perhaps one that says
// which of its cells count; SizeError if it is too large. Reads only the header, so that nothing large is allocated for
// a map that is refused.
void require_labels(GDALDataset& file, std::size_t bytes, const std::string& name, std::size_t most_cells);

// The ids of all cells, row by row. Cells without data are free: those of the nodata value, and those that a mask or a
// band of transparency leaves out. Throws InputError if there are negative ids, or the file is damaged.
std::vector<std::uint32_t> read_labels(GDALDataset& file, const MemoryFile& memory, const std::string& name);

}  // namespace waybreaker::geotiff
