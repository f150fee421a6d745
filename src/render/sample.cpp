#include "render/sample.hpp"

#include <algorithm>
#include <array>

namespace waybreaker::render {
namespace {

constexpr int coarse_side(int side, int step) {
    return (side + step - 1) / step;
}

std::vector<Look> looks_of(const Map& map, std::span<const Breach> removed) {
    std::vector<Look> looks(map.obstacles().size() + 1, Look::obstacle);
    for (const Obstacle& obstacle : map.obstacles()) {
        if (!obstacle.destructible) looks[obstacle.id.value] = Look::fixed_obstacle;
    }
    for (const Breach& removal : removed) looks[removal.obstacle.value] = Look::removed;
    return looks;
}

using LookCounts = std::array<int, look_count>;

// Label of a coarse cell: its look + 1, or 0 where it is free.
std::uint32_t coarse_label(const LookCounts& counts, int cells) {
    const auto count = [&](Look look) { return counts[std::size_t(look)]; };
    if (count(Look::removed) > 0) return std::uint32_t(Look::removed) + 1;
    if (2 * (count(Look::obstacle) + count(Look::fixed_obstacle)) < cells) return 0;
    const bool fixed = count(Look::fixed_obstacle) > count(Look::obstacle);
    return std::uint32_t(fixed ? Look::fixed_obstacle : Look::obstacle) + 1;
}

std::vector<std::uint32_t> coarse_labels(const Map& map, std::span<const Look> looks, int step) {
    std::vector<std::uint32_t> labels;
    for (int top = 0; top < map.height(); top += step) {
        const int bottom = std::min(top + step, map.height());
        for (int left = 0; left < map.width(); left += step) {
            const int right = std::min(left + step, map.width());
            LookCounts counts{};
            for (int y = top; y < bottom; ++y) {
                const std::uint32_t* row = map.labels().data() + std::size_t(y) * std::size_t(map.width());
                for (int x = left; x < right; ++x) {
                    if (row[x] != 0) ++counts[std::size_t(looks[row[x]])];
                }
            }
            labels.push_back(coarse_label(counts, (right - left) * (bottom - top)));
        }
    }
    return labels;
}

}  // namespace

Sample::Sample(const Map& map, std::span<const Breach> removed, int step)
    : map_(&map), step_(step), looks_(looks_of(map, removed)) {
    if (step == 1) return;
    coarse_labels_ = coarse_labels(map, looks_, step);
    looks_ = {Look::obstacle, Look::obstacle, Look::fixed_obstacle, Look::removed};  // by label; 0 is not used
}

site::LabelRaster Sample::raster() const {
    const std::span<const std::uint32_t> labels = step_ == 1 ? map_->labels() : std::span(coarse_labels_);
    return {coarse_side(map_->width(), step_), coarse_side(map_->height(), step_), labels};
}

}  // namespace waybreaker::render
