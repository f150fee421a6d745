// Whether there is a way at all, by steps from cell to cell.
#include <algorithm>
#include <vector>

#include "crossing/search.hpp"
#include "map/line_of_sight.hpp"

namespace waybreaker {

using namespace crossing;

bool CrossingSearcher::Search::stands(const Regions& regions, Cell c, std::span<const ObstacleId> removed) {
    if (!regions.map().grid().contains(c)) return false;
    const RegionId region = region_at(regions.map(), c);
    return !region || regions.within(region, removed);
}

bool CrossingSearcher::Search::has_steps(const Map& map, Cell start, Cell goal, const CrossingOptions& options) {
    interrupt_ = Interrupt(options.limits.seconds, options.limits.stop);
    const std::shared_ptr<const Regions> regions = regions_for(map, options);
    if (!regions->complete()) return true;
    std::vector<ObstacleId> removed(options.removed.begin(), options.removed.end());
    std::ranges::sort(removed);
    const OpenedMap opened(map, options.removed);
    const LineOfSight sight(opened, options.body);
    const auto free = [&](Cell c) { return stands(*regions, c, removed); };
    if (!free(start) || !free(goal)) return false;
    const auto width = std::size_t(map.width());
    std::vector<bool> seen(width * std::size_t(map.height()));
    std::vector<Cell> open{start};
    while (!open.empty()) {
        const Cell at = open.back();
        open.pop_back();
        if (at == goal || interrupt_.due()) return true;
        for (const Step step : {Step{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 1}, {-1, 1}, {-1, -1}, {1, -1}}) {
            const Cell next = at + step;
            if (!free(next) || seen[std::size_t(next.y) * width + std::size_t(next.x)]) continue;
            if (step.x != 0 && step.y != 0 && !sight.clear(at, next)) continue;
            seen[std::size_t(next.y) * width + std::size_t(next.x)] = true;
            open.push_back(next);
        }
    }
    return false;
}

}  // namespace waybreaker
