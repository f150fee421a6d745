// Outline: the edges of obstacles as closed rings, for drawing them as a few polygons instead of many squares.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "site/rings.hpp"

namespace waybreaker::render {

// What a cell looks like: what can be removed (a barrier: a wall, fence or hedge), what has to stay, what the ground
// closes, what nobody knows.
enum class Style : std::uint8_t {
    obstacle,
    barrier,
    fixed_obstacle,
    water,
    cliff,
    forbidden,
    off_road,
    unknown,
    removed
};
inline constexpr std::size_t style_count = 9;
// As a legend calls them.
inline constexpr std::array<std::string_view, style_count> style_words{
    "obstacle",         "wall, fence, hedge", "not removable",    "water",           "cliff or ditch",
    "forbidden ground", "off the roads",      "unknown: no data", "removed obstacle"};

// styles[label] says how the cells of that label are drawn. For each style, the rings around all cells of its labels as
// SVG path data, to be filled with the even-odd rule. One unit is one cell; corner (0, 0) is the upper-left corner of
// cell (0, 0). Touching cells of one label share their rings; different labels have rings of their own. Only true
// corners are written. Time O(cells).
std::array<std::string, style_count> outlines(const site::LabelRaster& raster, std::span<const Style> styles);

// The same for each label by itself: entry 0 is the rings of label 1. REQUIRES: no label is above `labels`.
std::vector<std::string> outlines(const site::LabelRaster& raster, std::size_t labels);

}  // namespace waybreaker::render
