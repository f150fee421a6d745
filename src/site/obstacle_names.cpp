#include "site/obstacle_names.hpp"

#include <algorithm>
#include <utility>

#include "site/first_cells.hpp"

namespace waybreaker::site {

std::size_t name_count(const ObstacleNames& names) {
    return std::size_t(
        std::count_if(names.begin(), names.end(), [](const std::string& name) { return !name.empty(); }));
}

std::vector<NamedCell> named_cells(LabelNames names, std::span<const std::uint32_t> labels) {
    return first_cells<NamedCell>(std::move(names), labels);
}

ObstacleNames obstacle_names(const Map& map, std::vector<NamedCell> cells) {
    if (cells.empty()) return {};
    ObstacleNames names(map.obstacles().size() + 1);
    for (NamedCell& named : cells) names[map.labels()[named.cell]] = std::move(named.name);
    return names;
}

}  // namespace waybreaker::site
