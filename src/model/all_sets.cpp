#include "model/all_sets.hpp"

#include <utility>

namespace waybreaker {

std::vector<std::vector<ObstacleId>> all_sets(std::span<const ObstacleId> obstacles, int largest,
                                              const std::function<bool(std::span<const ObstacleId>)>& allowed,
                                              std::size_t most) {
    std::vector<std::vector<ObstacleId>> sets{{}};
    std::size_t first = 0;
    for (int size = 1; first < sets.size() && size <= largest; ++size) {
        const std::size_t last = sets.size();
        for (std::size_t smaller = first; smaller < last; ++smaller) {
            for (const ObstacleId id : obstacles) {
                if (!sets[smaller].empty() && id <= sets[smaller].back()) continue;
                if (sets.size() == most) return {};
                std::vector<ObstacleId> larger = sets[smaller];
                larger.push_back(id);
                if (allowed(larger)) sets.push_back(std::move(larger));
            }
        }
        first = last;
    }
    return sets;
}

}  // namespace waybreaker
