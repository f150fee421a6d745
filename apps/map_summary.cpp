#include "map_summary.hpp"

namespace waybreaker::apps {

MapSummary summarise(const Map& map) {
    MapSummary summary;
    for (const Obstacle& obstacle : map.obstacles()) {
        summary.blocked += obstacle.cells;
        if (summary.largest == nullptr || obstacle.cells > summary.largest->cells) summary.largest = &obstacle;
    }
    summary.density = double(summary.blocked) / double(map.grid().cell_count());
    return summary;
}

}  // namespace waybreaker::apps
