#include "coalition/all_sets.hpp"

#include <algorithm>
#include <span>

#include "model/all_sets.hpp"

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
    const auto allowed = [&](std::span<const ObstacleId> set) { return problem.allows(set); };
    return waybreaker::all_sets(useful_obstacles(problem, columns), problem.spare_removals(), allowed, most);
}

}  // namespace waybreaker::coalition
