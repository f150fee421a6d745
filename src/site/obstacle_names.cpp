#include "site/obstacle_names.hpp"

#include <algorithm>
#include <utility>

namespace waybreaker::site {

std::size_t name_count(const ObstacleNames& names) {
    return std::size_t(
        std::count_if(names.begin(), names.end(), [](const std::string& name) { return !name.empty(); }));
}

std::vector<NamedCell> named_cells(LabelNames names, std::span<const std::uint32_t> labels) {
    std::vector<NamedCell> cells;
    std::uint32_t last = 0;
    for (std::size_t i = 0; i < labels.size() && !names.empty(); ++i) {
        if (labels[i] == last) continue;
        last = labels[i];
        const auto found = names.find(last);
        if (found == names.end()) continue;
        cells.push_back({i, std::move(found->second)});
        names.erase(found);
    }
    return cells;
}

ObstacleNames obstacle_names(const Map& map, std::vector<NamedCell> cells) {
    if (cells.empty()) return {};
    ObstacleNames names(map.obstacles().size() + 1);
    for (NamedCell& named : cells) names[map.labels()[named.cell]] = std::move(named.name);
    return names;
}

}  // namespace waybreaker::site
