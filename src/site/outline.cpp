#include "site/outline.hpp"

#include <array>
#include <cstdint>
#include <utility>

#include "site/rings.hpp"

namespace waybreaker::site {
namespace {

// The 4-connected sets of cells of one label each, numbered in scan order of their first cells.
std::vector<std::uint32_t> parts_of(const LabelRaster& raster) {
    constexpr std::uint32_t none = 0;
    std::vector<std::uint32_t> parts(raster.labels.size(), none);
    std::vector<std::size_t> stack;
    std::uint32_t count = 0;
    const auto width = std::size_t(raster.width);
    for (std::size_t first = 0; first < parts.size(); ++first) {
        const std::uint32_t label = raster.labels[first];
        if (label == 0 || parts[first] != none) continue;
        const auto reach = [&](std::size_t cell) {
            if (raster.labels[cell] != label || parts[cell] != none) return;
            parts[cell] = count;
            stack.push_back(cell);
        };
        ++count;
        reach(first);
        while (!stack.empty()) {
            const std::size_t cell = stack.back();
            stack.pop_back();
            if (cell % width != 0) reach(cell - 1);
            if (cell % width != width - 1) reach(cell + 1);
            if (cell >= width) reach(cell - width);
            if (cell + width < parts.size()) reach(cell + width);
        }
    }
    return parts;
}

Ring closed(std::span<const Cell> corners, Cell offset) {
    Ring ring;
    ring.reserve(corners.size() + 1);
    for (const Cell c : corners) ring.emplace_back(c.x + offset.x - 0.5, c.y + offset.y - 0.5);
    ring.push_back(ring.front());
    return ring;
}

// By label. Cell (0, 0) of the raster is cell `offset` of the map.
std::vector<std::vector<Polygon>> polygons_of(const LabelRaster& raster, std::size_t label_count, Cell offset) {
    const std::vector<std::uint32_t> parts = parts_of(raster);
    std::vector<std::vector<Polygon>> polygons(label_count + 1);
    std::vector<std::size_t> place(parts.size() + 1);  // of a part's polygon among those of its label, from 1
    trace_rings(raster, [&](const LabelRing& ring) {
        const Cell first = ring.corners.front();
        const std::uint32_t part = parts[std::size_t(first.y) * std::size_t(raster.width) + std::size_t(first.x)];
        std::vector<Polygon>& of_label = polygons[ring.label];
        // A part's first cell in scan order is at its outer ring, which therefore comes before its holes.
        if (place[part] == 0) {
            of_label.emplace_back();
            place[part] = of_label.size();
        }
        of_label[place[part] - 1].push_back(closed(ring.corners, offset));
    });
    return polygons;
}

}  // namespace

std::vector<std::vector<Polygon>> outlines(const Map& map) {
    return polygons_of({map.width(), map.height(), map.labels()}, map.obstacles().size(), {0, 0});
}

std::vector<Polygon> outline(const Map& map, ObstacleId id) {
    const Box& bounds = map.obstacle(id).bounds;
    const int width = bounds.max.x - bounds.min.x + 1;
    const int height = bounds.max.y - bounds.min.y + 1;
    std::vector<std::uint32_t> cells;
    cells.reserve(std::size_t(width) * std::size_t(height));
    for (Cell c = bounds.min; c.y <= bounds.max.y; ++c.y) {
        for (c.x = bounds.min.x; c.x <= bounds.max.x; ++c.x) cells.push_back(map.obstacle_at(c) == id ? 1 : 0);
    }
    return std::move(polygons_of({width, height, cells}, 1, bounds.min)[1]);
}

}  // namespace waybreaker::site
