#include "site/unknown_ground.hpp"

namespace waybreaker::site {

std::vector<bool> unknown_obstacles(const Map& map, const ObstacleTags& tags) {
    std::vector<bool> unknown(map.obstacles().size() + 1);
    if (const auto tagged = tags.find(unknown_tag); tagged != tags.end()) {
        for (const ObstacleId id : tagged->second) unknown[id.value] = true;
    }
    return unknown;
}

std::uint64_t unknown_cells(const Map& map, const ObstacleTags& tags) {
    std::uint64_t cells = 0;
    const std::vector<bool> unknown = unknown_obstacles(map, tags);
    for (const Obstacle& obstacle : map.obstacles()) {
        if (unknown[obstacle.id.value]) cells += obstacle.cells;
    }
    return cells;
}

}  // namespace waybreaker::site
