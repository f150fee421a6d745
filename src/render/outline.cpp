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

}  // namespace

std::array<std::string, style_count> outlines(const site::LabelRaster& raster, std::span<const Style> styles) {
    std::array<std::string, style_count> paths;
    std::array<Cell, style_count> ring_starts{};  // where relative coordinates start
    site::trace_rings(raster, [&](const site::LabelRing& ring) {
        const std::size_t style = std::size_t(styles[ring.label]);
        std::string& path = paths[style];
        const Cell start = ring.corners.front();
        path += 'm';
        append(path, start.x - ring_starts[style].x);
        append(path, start.y - ring_starts[style].y);
        ring_starts[style] = start;
        for (std::size_t i = 1; i < ring.corners.size(); ++i) append_side(path, ring.corners[i - 1], ring.corners[i]);
        path += 'z';  // draws the last side
    });
    return paths;
}

}  // namespace waybreaker::render
