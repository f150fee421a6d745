#include "map/map_size.hpp"

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "waybreaker/error.hpp"

namespace waybreaker {

void require_size(int width, int height) {
    const bool in_range = width >= 1 && height >= 1 && width <= max_side && height <= max_side;
    if (in_range && std::size_t(width) * std::size_t(height) <= max_cells) return;
    throw InputError(ErrorCode::out_of_range, "the size of the map",
                     "a map of " + std::to_string(width) + " x " + std::to_string(height) +
                         " cells is out of range: sides go from 1 to " + std::to_string(max_side) + ", with at most " +
                         std::to_string(max_cells) + " cells in all");
}

std::size_t count_labels(std::span<const std::uint32_t> labels) {
    if (labels.empty()) return 0;
    const std::size_t largest = *std::max_element(labels.begin(), labels.end());
    // A bit for each number, where that is no more than a copy of the labels.
    if (largest / 32 <= labels.size()) {
        std::vector<bool> seen(largest + 1);
        for (const std::uint32_t label : labels) seen[label] = true;
        return std::size_t(std::count(seen.begin() + 1, seen.end(), true));
    }
    std::vector<std::uint32_t> sorted(labels.begin(), labels.end());
    std::sort(sorted.begin(), sorted.end());
    const auto end = std::unique(sorted.begin(), sorted.end());
    return std::size_t(end - sorted.begin()) - (sorted.front() == 0 ? 1 : 0);
}

std::size_t map_bytes(int width, int height, std::size_t obstacles) {
    const auto bits = [](int lines, int cells) {
        return (std::size_t(cells) / 64 + 1) * (std::size_t(lines) + 2) * sizeof(std::uint64_t);
    };
    const std::size_t cells = std::size_t(width) * std::size_t(height);
    const std::size_t rows = std::size_t(height) * sizeof(std::shared_ptr<const std::uint32_t[]>);
    return bits(height, width) + bits(width, height) + rows + cells * sizeof(std::uint32_t) +
           obstacles * sizeof(Obstacle);
}

}  // namespace waybreaker
