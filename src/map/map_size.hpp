// What a map takes in memory, known before it is made; and how many obstacles it will have.
#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "waybreaker/map.hpp"

namespace waybreaker {

// Throws InputError unless a map may have that size, by the limits of grid.hpp.
void require_size(int width, int height);

// Limits for a map that is being read.
struct MapLimits {
    std::size_t cells = max_cells;
    // Called with the bytes a map will take, before they are allocated; throws to refuse the map.
    std::function<void(std::size_t bytes)> admit = {};
};

// The obstacles of a grid. Time O(cells / 64 + runs), memory 4 bytes a run.
std::size_t count_obstacles(const Grid& grid, Connectivity connectivity);
// Those of a label layer: its different labels, without 0. Memory up to 4 bytes a cell.
std::size_t count_labels(std::span<const std::uint32_t> labels);

// Bytes of a map. Within a few percent.
std::size_t map_bytes(int width, int height, std::size_t obstacles);

}  // namespace waybreaker
