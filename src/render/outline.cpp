#include "render/outline.hpp"

#include "site/rings.hpp"
#include "waybreaker/cell.hpp"

namespace waybreaker::render {
namespace {

// A number of path data: a sign separates numbers as well as a space does.
void append(std::string& path, int number) {
    if (number >= 0 && !path.empty() && path.back() >= '0' && path.back() <= '9') path += ' ';
    path += std::to_string(number);
}

void append_side(std::string& path, Cell from, Cell to) {
    const bool level = from.y == to.y;
    path += level ? 'h' : 'v';
    append(path, level ? to.x - from.x : to.y - from.y);
}

// `path_of(label)`: which of the paths its rings belong to.
template <class PathOf>
void trace(const site::LabelRaster& raster, std::span<std::string> paths, PathOf path_of) {
    std::vector<Cell> ring_starts(paths.size());  // where relative coordinates start
    site::trace_rings(raster, [&](const site::LabelRing& ring) {
        const std::size_t which = path_of(ring.label);
        std::string& path = paths[which];
        const Cell start = ring.corners.front();
        path += 'm';
        append(path, start.x - ring_starts[which].x);
        append(path, start.y - ring_starts[which].y);
        ring_starts[which] = start;
        for (std::size_t i = 1; i < ring.corners.size(); ++i) append_side(path, ring.corners[i - 1], ring.corners[i]);
        path += 'z';  // draws the last side
    });
}

}  // namespace

std::array<std::string, style_count> outlines(const site::LabelRaster& raster, std::span<const Style> styles) {
    std::array<std::string, style_count> paths;
    trace(raster, paths, [&](std::uint32_t label) { return std::size_t(styles[label]); });
    return paths;
}

std::vector<std::string> outlines(const site::LabelRaster& raster, std::size_t labels) {
    std::vector<std::string> paths(labels);
    trace(raster, paths, [](std::uint32_t label) { return std::size_t(label - 1); });
    return paths;
}

}  // namespace waybreaker::render
