#include "site/obstacle_kinds.hpp"

namespace waybreaker::site {

std::vector<KindOfCell> kinds_of_cells(LabelKinds kinds, std::span<const std::uint32_t> labels) {
    std::vector<KindOfCell> cells;
    std::uint32_t last = 0;
    for (std::size_t i = 0; i < labels.size() && !kinds.empty(); ++i) {
        if (labels[i] == last) continue;
        last = labels[i];
        const auto found = kinds.find(last);
        if (found == kinds.end()) continue;
        cells.push_back({i, found->second});
        kinds.erase(found);
    }
    return cells;
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
        const std::size_t id = obstacle.id.value;
        cells[std::size_t(id < kinds.size() ? kinds[id] : ObstacleKind::unknown)] += obstacle.cells;
    }
    return cells;
}

}  // namespace waybreaker::site
