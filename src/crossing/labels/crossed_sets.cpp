#include "crossing/labels/crossed_sets.hpp"

#include <cmath>

#include "waybreaker/error.hpp"

namespace waybreaker::crossing {

void CrossedSets::clear() {
    sets_.clear();
    done_.clear();
    paid_.clear();
}

std::uint32_t CrossedSets::find_or_add(std::span<const ObstacleId> sorted) {
    const std::uint32_t known = sets_.size();
    const std::uint32_t set = sets_.find_or_add(sorted);
    if (set < known) return set;
    const CrossingOptions& options = *query_.options;
    const Opener& opener = *query_.opener;
    if (opener.done_after) {
        const double cells = opener.done_after(query_.without_removed(sorted));
        if (!(cells >= 0)) throw InputError("done_after must say a number, at least 0");
        done_.push_back(2 * cells);
    }
    if (!options.prices.empty()) {
        double paid = 0;
        for (const ObstacleId id : query_.without_removed(sorted)) paid += 2 * options.prices[id.value];
        paid_.push_back(paid);
    }
    return set;
}

double CrossedSets::opened_after(std::span<const ObstacleId> sorted) const {
    const std::vector<ObstacleId> ids = query_.without_removed(sorted);
    if (ids.empty()) return 0;
    const double cells = query_.options->opened_after(ids);
    if (std::isnan(cells)) throw InputError("opened_after must say a number");
    return 2 * cells;
}

double CrossedSets::unpaid_cost(double ground, std::span<const ObstacleId> sorted) const {
    if (!query_.opener->done_after) return ground;
    return with_mission(ground, 2 * query_.opener->done_after(query_.without_removed(sorted)));
}

}  // namespace waybreaker::crossing
