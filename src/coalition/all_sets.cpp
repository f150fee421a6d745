#include "coalition/all_sets.hpp"

#include <algorithm>

namespace waybreaker::coalition {
namespace {

Set useful_obstacles(const Problem& problem, const Columns& columns) {
    Set useful;
    for (const Obstacle& obstacle : problem.map().obstacles()) {
        if (!obstacle.destructible || contains(problem.forced(), obstacle.id)) continue;
        if (std::ranges::find(problem.rules().protect, obstacle.id) != problem.rules().protect.end()) continue;
        for (std::size_t i = 0; i < columns.size(); ++i) {
            if (!columns.may_gain(i, obstacle)) continue;
            useful.push_back(obstacle.id);
            break;
        }
    }
    return useful;
}

}  // namespace

std::vector<Set> all_sets(const Problem& problem, const Columns& columns, std::size_t most) {
    const Set useful = useful_obstacles(problem, columns);
    std::vector<Set> sets{{}};
    std::size_t first = 0;
    for (int size = 1; first < sets.size() && size <= problem.spare_removals(); ++size) {
        const std::size_t last = sets.size();
        for (std::size_t smaller = first; smaller < last; ++smaller) {
            for (const ObstacleId id : useful) {
                if (!sets[smaller].empty() && id <= sets[smaller].back()) continue;
                if (sets.size() == most) return {};
                Set larger = sets[smaller];
                larger.push_back(id);
                if (problem.allows(larger)) sets.push_back(std::move(larger));
            }
        }
        first = last;
    }
    return sets;
}

}  // namespace waybreaker::coalition
