// The paper's choice: the obstacles the search ran into most often (section 3, "argmax obstacles(o)").
#include <algorithm>

#include "waybreaker/breach.hpp"

namespace waybreaker {

std::vector<ObstacleId> most_hit(const Map& map, std::span<const std::uint32_t> hits, int n) {
    std::vector<ObstacleId> chosen;
    for (const Obstacle& obstacle : map.obstacles()) {
        if (obstacle.destructible && hits[obstacle.id.value] > 0) chosen.push_back(obstacle.id);
    }
    const auto more_hits = [hits](ObstacleId a, ObstacleId b) {
        return hits[a.value] != hits[b.value] ? hits[a.value] > hits[b.value] : a < b;
    };
    const auto count = std::min(chosen.size(), std::size_t(std::max(n, 0)));
    std::partial_sort(chosen.begin(), chosen.begin() + std::ptrdiff_t(count), chosen.end(), more_hits);
    chosen.resize(count);
    return chosen;
}

}  // namespace waybreaker
