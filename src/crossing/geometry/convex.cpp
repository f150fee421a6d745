#include "crossing/geometry/convex.hpp"

#include <algorithm>

#include "crossing/tuning.hpp"

namespace waybreaker::crossing {

void Convex::start_query(const Regions& regions, int reach) {
    regions_ = &regions;
    if (identity_ == regions.map().identity() && reach_ == reach) return;
    identity_ = regions.map().identity();
    reach_ = reach;
    known_.assign(regions.obstacle_limit(), Known::unknown);
}

bool Convex::look(ObstacleId obstacle) const {
    const Box box = regions_->bounds(obstacle);
    const Map& map = regions_->map();
    const Cell min{std::max(box.min.x, 0), std::max(box.min.y, 0)};
    const Cell max{std::min(box.max.x, map.width() - 1), std::min(box.max.y, map.height() - 1)};
    if (std::int64_t(max.x - min.x + 1) * (max.y - min.y + 1) > tuning::largest_convex_box) return false;
    for (Cell c = min; c.y <= max.y; ++c.y) {
        for (c.x = min.x; c.x <= max.x; ++c.x) {
            bool others = false;
            regions_->for_each_member(region_at(map, c), [&](ObstacleId member) {
                others = others || (member && member != obstacle && !regions_->is_edge(member));
            });
            if (others) return false;
        }
    }
    return true;
}

}  // namespace waybreaker::crossing
