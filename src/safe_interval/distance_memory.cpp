#include "safe_interval/distance_memory.hpp"

#include <algorithm>

#include "safe_interval/tuning.hpp"

namespace waybreaker::safe_interval {

const Distances& DistanceMemory::get(const OpenedMap& map, const LineOfSight& sight, const Body& body,
                                     std::span<const Cell> way, Region region, const Deadline& deadline) {
    const bool same_map = map_ == map.map().identity() && std::ranges::equal(removed_, map.removed());
    if (!same_map || bytes_ > tuning::most_bytes) {
        known_.clear();
        open_steps_.clear();
        bytes_ = 0;
        map_ = map.map().identity();
        width_ = map.width();
        height_ = map.height();
        removed_.assign(map.removed().begin(), map.removed().end());
    }
    const Key key{{body.radius, body.corners}, region, {way.begin(), way.end()}};
    if (const auto found = known_.find(key); found != known_.end()) {
        if (found->second.complete()) return found->second;
        bytes_ -= found->second.bytes();
        known_.erase(found);
    }
    const Distances& distances =
        known_.emplace(key, Distances(map, sight, open_steps(body), way, region, deadline)).first->second;
    bytes_ += distances.bytes();
    return distances;
}

OpenSteps& DistanceMemory::open_steps(const Body& body) {
    return open_steps_.try_emplace({body.radius, body.corners}, width_, height_).first->second;
}

}  // namespace waybreaker::safe_interval
