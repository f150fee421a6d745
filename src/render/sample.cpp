#include "render/sample.hpp"

#include <algorithm>
#include <array>
#include <numeric>

#include "site/unknown_ground.hpp"

namespace waybreaker::render {
namespace {

constexpr int coarse_side(int side, int step) {
    return (side + step - 1) / step;
}

Style style_of(bool destructible, site::ObstacleKind kind) {
    using enum site::ObstacleKind;
    if (destructible) return kind == barrier ? Style::barrier : Style::obstacle;
    switch (kind) {
        case water:
            return Style::water;
        case cliff:
            return Style::cliff;
        case forbidden:
            return Style::forbidden;
        case off_road:
            return Style::off_road;
        default:
            return Style::fixed_obstacle;
    }
}

std::vector<Style> styles_of(const Map& map, std::span<const Breach> removed, const site::Annotations& known) {
    std::vector<Style> styles = standing_styles(map, known);
    for (const Breach& breach : removed) styles[breach.obstacle.value] = Style::removed;
    return styles;
}

using StyleCounts = std::array<int, style_count>;

// Label of a coarse cell: its style + 1, or 0 where it is free.
std::uint32_t coarse_label(const StyleCounts& counts, int cells) {
    constexpr std::size_t removed = std::size_t(Style::removed);
    if (counts[removed] > 0) return removed + 1;
    if (2 * std::accumulate(counts.begin(), counts.end(), 0) < cells) return 0;
    return std::uint32_t(std::max_element(counts.begin(), counts.end()) - counts.begin()) + 1;
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

std::vector<Style> standing_styles(const Map& map, const site::Annotations& known) {
    const std::vector<bool> unknown = site::unknown_obstacles(map, known.tags);
    std::vector<Style> styles(map.obstacles().size() + 1, Style::obstacle);
    for (const Obstacle& obstacle : map.obstacles()) {
        styles[obstacle.id.value] = unknown[obstacle.id.value]
                                        ? Style::unknown
                                        : style_of(obstacle.destructible, site::kind_of(known.kinds, obstacle.id));
    }
    return styles;
}

Sample::Sample(const Map& map, std::span<const Breach> removed, int step, const site::Annotations& known)
    : map_(&map), step_(step), styles_(styles_of(map, removed, known)) {
    if (step == 1) return;
    coarse_labels_ = coarse_labels(map, styles_, step);
    // By label; 0 is not used.
    styles_.assign(style_count + 1, Style::obstacle);
    for (std::size_t i = 0; i < style_count; ++i) styles_[i + 1] = Style(i);
}

site::LabelRaster Sample::raster() const {
    const std::span<const std::uint32_t> labels = step_ == 1 ? map_->labels() : std::span(coarse_labels_);
    return {coarse_side(map_->width(), step_), coarse_side(map_->height(), step_), labels};
}

}  // namespace waybreaker::render
