// Outline: the edges of obstacles as closed rings, for drawing them as a few polygons instead of many squares.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>

namespace waybreaker::render {

enum class Look : std::uint8_t { obstacle, fixed_obstacle, removed };
inline constexpr std::size_t look_count = 3;

// Labels row by row, 0 = free; looks[label] says how the cells of that label are drawn.
struct LabelRaster {
    int width;
    int height;
    std::span<const std::uint32_t> labels;
    std::span<const Look> looks;
};

// For each look, the rings around all cells of its labels as SVG path data, to be filled with the even-odd rule. One
// unit is one cell; corner (0, 0) is the upper-left corner of cell (0, 0). Touching cells of one label share their
// rings; different labels have rings of their own. Only true corners are written. Time O(cells).
std::array<std::string, look_count> outlines(const LabelRaster& raster);

}  // namespace waybreaker::render
