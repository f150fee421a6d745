// Distances of earlier queries: who plans a team asks for the same agents again and again.
#pragma once

#include <map>
#include <memory>
#include <tuple>
#include <vector>

#include "safe_interval/distances.hpp"

namespace waybreaker::safe_interval {

class DistanceMemory {
  public:
    // As the constructor of Distances. What is returned stays until the next call.
    const Distances& get(const OpenedMap& map, const LineOfSight& sight, const Body& body, Cell goal,
                         std::span<const Cell> way, const Deadline& deadline);

  private:
    struct Key {
        Cell goal;
        double radius;
        Corners corners;
        std::vector<Cell> way;
        friend bool operator<(const Key& a, const Key& b) {
            return std::tie(a.goal, a.radius, a.corners, a.way) < std::tie(b.goal, b.radius, b.corners, b.way);
        }
    };

    std::shared_ptr<const void> map_;
    std::vector<ObstacleId> removed_;
    std::map<Key, Distances> known_;
    std::size_t bytes_ = 0;
};

}  // namespace waybreaker::safe_interval
