// Cells of a label map that something is known of, as a metadata item of its GeoTIFF: a line with the map's western and
// northern edge and the side of a cell, in its coordinate system, then the runs of cells, row by row. The first line
// keeps them in place when gdal_translate cuts a piece out.
//
//     457264.5 5460412.8 2.4
//     78DAD3E011040000A40046
//
// The second line is a zlib stream in hexadecimal digits of three numbers for each run: how many rows it lies below the
// one before, how many cells to the right of that one's end, or of the map's edge in another row, and its length. A
// number is seven bits in each byte, the lowest first; the eighth says that more follow (LEB128). In place of this line
// there may be one for each run, of its column, row and length: "12 40 17".
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "site/cell_run.hpp"

namespace waybreaker::labels {

inline constexpr const char* bridges_item = "WAYBREAKER_BRIDGES";
inline constexpr const char* ways_item = "WAYBREAKER_WAYS";
inline constexpr const char* unknown_item = "WAYBREAKER_UNKNOWN";

// zlib, in hexadecimal digits: whoever reads rasters has it. What was deflated is empty if it is no such text, or more
// than that many bytes.
using Deflate = std::function<std::string(const std::vector<std::uint8_t>& bytes)>;
using Inflate = std::function<std::vector<std::uint8_t>(std::string_view digits, std::size_t most)>;

// Empty if there are none. `transform` is that of the map (site/georeference.hpp). REQUIRES: runs row by row that do
// not overlap.
std::string cells_text(const std::vector<site::CellRun>& runs, const std::array<double, 6>& transform,
                       const Deflate& deflate);

// What that item of a file says, in cells of a map of width x height that lies there, row by row; none if its cells are
// no longer those that the item counts. Throws InputError if it cannot be understood; `name` is how the file is called
// in errors.
std::vector<site::CellRun> read_cells(std::string_view text, const char* item, const std::array<double, 6>& transform,
                                      int width, int height, const Inflate& inflate, const std::string& name);

}  // namespace waybreaker::labels
