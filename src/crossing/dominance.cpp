#include "crossing/dominance.hpp"

#include <algorithm>

#include "crossing/geometry/border.hpp"

namespace waybreaker::crossing {

bool Dominance::operator()(const Label& better, const Label& worse) const {
    double left = gain(better, worse);  // that may be paid for what only `better` has crossed
    if (left < 0 && (query_.options->prices.empty() || !query_.by_count)) return false;
    if (better.set == worse.set) return left >= 0;
    const auto mine = sets_[better.set];
    const auto theirs = sets_[worse.set];
    // A path that has not waited for the same takes another way.
    if (worse.gate != 0 && !std::ranges::includes(mine, groups_[worse.gate].terms().opened)) return false;
    int more = 0;
    double more_weight = 0;
    for (const ObstacleId obstacle : mine) {
        if (std::binary_search(theirs.begin(), theirs.end(), obstacle)) continue;
        ++more;
        more_weight += weight(obstacle);
        left -= price(obstacle);
    }
    if (more == 0 && left >= 0) return true;
    if (!query_.by_count) {
        // Enumeration wants each of several sets of one cost; otherwise a full set crosses nothing else.
        return !query_.enumerates && theirs.size() >= query_.capacity() && better.estimate <= worse.estimate &&
               all_lost(worse, mine);
    }
    for (const ObstacleId obstacle : theirs) {
        if (std::binary_search(mine.begin(), mine.end(), obstacle) || !lost(obstacle, worse)) continue;
        --more;
        more_weight -= weight(obstacle);
        left += price(obstacle);
    }
    return more <= 0 && more_weight <= 0 && left >= 0;
}

bool Dominance::all_lost(const Label& label, std::span<const ObstacleId> but) const {
    return std::ranges::all_of(sets_[label.set], [&](ObstacleId obstacle) {
        return std::ranges::binary_search(but, obstacle) || lost(obstacle, label);
    });
}

// How much less it costs, prices aside. At the goal waits and flights are over.
double Dominance::gain(const Label& better, const Label& worse) const {
    if (better.at != query_.goal) return worse.cost - better.cost;
    constexpr double rounding = 1e-12;  // relative: one path to the goal in other pieces is reported once
    return (worse.estimate - sets_.paid(worse.set)) * (1 + rounding) - (better.estimate - sets_.paid(better.set));
}

// Whether no path that is short enough can come back to the obstacle, or no shortest path does.
bool Dominance::lost(ObstacleId obstacle, const Label& label) const {
    if (convex_.left(obstacle, label.at)) return true;
    const Box box = query_.regions->bounds(obstacle);
    return label.cost + gap(label.at, box) + gap(query_.goal, box) > progress_.limit;
}

double Dominance::weight(ObstacleId obstacle) const {
    const bool weighs = query_.options->budget < infinity;
    return weighs ? query_.regions->weight(obstacle) : 0;
}

}  // namespace waybreaker::crossing
