#include "site/obstacle_kinds.hpp"

#include <algorithm>
#include <utility>

#include "site/first_cells.hpp"

namespace waybreaker::site {

ObstacleKind kind_called(std::string_view word) {
    const auto* const found = std::find(obstacle_kind_words.begin(), obstacle_kind_words.end(), word);
    return found == obstacle_kind_words.end() ? ObstacleKind::unknown
                                              : ObstacleKind(found - obstacle_kind_words.begin());
}

std::vector<KindOfCell> kinds_of_cells(LabelKinds kinds, std::span<const std::uint32_t> labels) {
    return first_cells<KindOfCell>(std::move(kinds), labels);
}

ObstacleKinds obstacle_kinds(const Map& map, const std::vector<KindOfCell>& cells) {
    if (cells.empty()) return {};
    ObstacleKinds kinds(map.obstacles().size() + 1, ObstacleKind::unknown);
    for (const KindOfCell& cell : cells) kinds[map.labels()[cell.cell]] = cell.kind;
    return kinds;
}

std::array<std::uint64_t, obstacle_kind_words.size()> cells_by_kind(const Map& map, const ObstacleKinds& kinds) {
    std::array<std::uint64_t, obstacle_kind_words.size()> cells{};
    for (const Obstacle& obstacle : map.obstacles()) {
        cells[std::size_t(kind_of(kinds, obstacle.id))] += obstacle.cells;
    }
    return cells;
}

}  // namespace waybreaker::site
