#include "io/map_frame.hpp"

#include <cmath>

namespace waybreaker::io {
namespace {

Point origin_of(const MapFile& map) {
    if (map.origin) return {map.origin->at(0), map.origin->at(1)};
    if (!map.georeference) return {0, 0};
    const std::array<double, 6>& transform = map.georeference->transform;
    const double metres = map.cell_size / transform[1];  // of a unit of the coordinate system
    return {metres * transform[0], metres * (transform[3] + map.map.height() * transform[5])};
}

}  // namespace

MapFrame::MapFrame(const MapFile& map)
    : origin_(origin_of(map)), cell_size_(map.cell_size), height_(map.map.height()) {}

Point MapFrame::metres(Point cell) const {
    return {origin_.x + (cell.x + 0.5) * cell_size_, origin_.y + (height_ - 0.5 - cell.y) * cell_size_};
}

Point MapFrame::cell(Point metres) const {
    // Rows are counted from below before y is turned: after that, an edge would belong to the cell below it.
    return {std::floor((metres.x - origin_.x) / cell_size_),
            height_ - 1 - std::floor((metres.y - origin_.y) / cell_size_)};
}

}  // namespace waybreaker::io
