#include "map/map_size.hpp"

#include <algorithm>
#include <memory>
#include <vector>

namespace waybreaker {

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
