// Distances of earlier queries: the planner of a team asks for the same agents again and again.
#pragma once

#include <map>
#include <memory>
#include <tuple>
#include <utility>
#include <vector>

#include "safe_interval/distances.hpp"

namespace waybreaker::safe_interval {

class DistanceMemory {
  public:
    // As the constructor of Distances. What is returned stays until the next call, and so do the steps.
    const Distances& get(const OpenedMap& map, const LineOfSight& sight, const Body& body, std::span<const Cell> way,
                         Region region, const Deadline& deadline);
    // Steps on the map last asked for.
    OpenSteps& open_steps(const Body& body);

  private:
    using BodyKey = std::pair<double, Corners>;
    using Key = std::tuple<BodyKey, Region, std::vector<Cell>>;

    std::shared_ptr<const void> map_;
    std::vector<ObstacleId> removed_;
    int width_ = 0;
    int height_ = 0;
    std::map<BodyKey, OpenSteps> open_steps_;
    std::map<Key, Distances> known_;
    std::size_t bytes_ = 0;
};

}  // namespace waybreaker::safe_interval
