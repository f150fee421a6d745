#include "render/sample.hpp"

#include <algorithm>
#include <array>

namespace waybreaker::render {
namespace {

constexpr int coarse_side(int side, int step) {
    return (side + step - 1) / step;
}

std::vector<Style> styles_of(const Map& map, std::span<const Breach> removed, const site::ObstacleKinds& kinds) {
    std::vector<Style> styles(map.obstacles().size() + 1, Style::obstacle);
    for (const Obstacle& obstacle : map.obstacles()) {
        if (obstacle.destructible) continue;
        const bool water = site::kind_of(kinds, obstacle.id) == site::ObstacleKind::water;
        styles[obstacle.id.value] = water ? Style::water : Style::fixed_obstacle;
    }
    for (const Breach& breach : removed) styles[breach.obstacle.value] = Style::removed;
    return styles;
}

using StyleCounts = std::array<int, style_count>;

// Label of a coarse cell: its style + 1, or 0 where it is free.
std::uint32_t coarse_label(const StyleCounts& counts, int cells) {
    const auto count = [&](Style style) { return counts[std::size_t(style)]; };
    if (count(Style::removed) > 0) return std::uint32_t(Style::removed) + 1;
    if (2 * (count(Style::obstacle) + count(Style::fixed_obstacle) + count(Style::water)) < cells) return 0;
    Style most = Style::obstacle;
    for (const Style style : {Style::fixed_obstacle, Style::water}) {
        if (count(style) > count(most)) most = style;
    }
    return std::uint32_t(most) + 1;
}

std::vector<std::uint32_t> coarse_labels(const Map& map, std::span<const Style> styles, int step) {
    std::vector<std::uint32_t> labels;
    for (int top = 0; top < map.height(); top += step) {
        const int bottom = std::min(top + step, map.height());
        for (int left = 0; left < map.width(); left += step) {
            const int right = std::min(left + step, map.width());
            StyleCounts counts{};
            for (int y = top; y < bottom; ++y) {
                const std::uint32_t* row = map.labels().data() + std::size_t(y) * std::size_t(map.width());
                for (int x = left; x < right; ++x) {
                    if (row[x] != 0) ++counts[std::size_t(styles[row[x]])];
                }
            }
            labels.push_back(coarse_label(counts, (right - left) * (bottom - top)));
        }
    }
    return labels;
}

}  // namespace

Sample::Sample(const Map& map, std::span<const Breach> removed, int step, const site::ObstacleKinds& kinds)
    : map_(&map), step_(step), styles_(styles_of(map, removed, kinds)) {
    if (step == 1) return;
    coarse_labels_ = coarse_labels(map, styles_, step);
    // By label; 0 is not used.
    styles_ = {Style::obstacle, Style::obstacle, Style::fixed_obstacle, Style::water, Style::removed};
}

site::LabelRaster Sample::raster() const {
    const std::span<const std::uint32_t> labels = step_ == 1 ? map_->labels() : std::span(coarse_labels_);
    return {coarse_side(map_->width(), step_), coarse_side(map_->height(), step_), labels};
}

}  // namespace waybreaker::render
