#include "crossing/dominance.hpp"

#include <algorithm>

namespace waybreaker::crossing {

bool Dominance::operator()(const Label& better, const Label& worse) const {
    double left = gain(better, worse);  // that may be paid for what only `better` has crossed
    if (left < 0 && (prices.empty() || !by_count)) return false;
    if (better.set == worse.set) return left >= 0;
    const auto mine = sets[better.set];
    const auto theirs = sets[worse.set];
    // Who has not waited for the same goes another way.
    if (worse.gate != 0 && !std::ranges::includes(mine, groups[worse.gate].terms().opened)) return false;
    int more = 0;
    double more_weight = 0;
    for (const ObstacleId obstacle : mine) {
        if (std::binary_search(theirs.begin(), theirs.end(), obstacle)) continue;
        ++more;
        more_weight += weight(obstacle);
        left -= price(obstacle);
    }
    if (more == 0 && left >= 0) return true;
    if (!by_count) return theirs.size() >= full && better.estimate <= worse.estimate && all_lost(worse, mine);
    for (const ObstacleId obstacle : theirs) {
        if (std::binary_search(mine.begin(), mine.end(), obstacle) || !lost(obstacle, worse)) continue;
        --more;
        more_weight -= weight(obstacle);
        left += price(obstacle);
    }
    return more <= 0 && more_weight <= 0 && left >= 0;
}

bool Dominance::all_lost(const Label& label, std::span<const ObstacleId> but) const {
    return std::ranges::all_of(sets[label.set], [&](ObstacleId obstacle) {
        return std::ranges::binary_search(but, obstacle) || lost(obstacle, label);
    });
}

// How much cheaper, what is paid aside. At the goal waits and flights are over.
double Dominance::gain(const Label& better, const Label& worse) const {
    if (better.at != goal) return worse.cost - better.cost;
    constexpr double rounding = 1e-12;  // relative: one way to the goal in other pieces is told of once
    if (prices.empty()) return worse.estimate * (1 + rounding) - better.estimate;
    return (worse.estimate - paid[worse.set]) * (1 + rounding) - (better.estimate - paid[better.set]);
}

// No path that is short enough can come back to the obstacle, or no shortest path does.
bool Dominance::lost(ObstacleId obstacle, const Label& label) const {
    if (convex.left(obstacle, label.at)) return true;
    const Box box = regions.bounds(obstacle);
    return label.cost + gap(label.at, box) + gap(goal, box) > limit;
}

}  // namespace waybreaker::crossing
