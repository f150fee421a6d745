// Border: the places where an agent touches a region, as lattice points.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <unordered_map>
#include <vector>

#include "crossing/geometry/lattice.hpp"
#include "crossing/geometry/regions.hpp"
#include "waybreaker/map.hpp"

namespace waybreaker::crossing {

inline constexpr std::uint32_t no_neighbour = UINT32_MAX;

// All lattice points on the border of a region, grown by the body; no place on it is farther than half a cell from one
// of them.
struct Border {
    std::vector<Vertex> points;
    // Neighbours of each point: others a cell away, to which the agent can go straight.
    std::vector<std::array<std::uint32_t, 4>> neighbours;
    Vertex min;  // the least box around them
    Vertex max;
};

// From a vertex to the box around a border.
inline double gap(Vertex v, const Border& border) {
    return length(
        {std::max({border.min.x - v.x, v.x - border.max.x, 0}), std::max({border.min.y - v.y, v.y - border.max.y, 0})});
}

// From a vertex to all places where an agent touches the cells of a box.
inline double gap(Vertex v, const Box& box) {
    return length({std::max({2 * box.min.x - 2 - v.x, v.x - 2 * box.max.x - 2, 0}),
                   std::max({2 * box.min.y - 2 - v.y, v.y - 2 * box.max.y - 2, 0})});
}

class Borders {
  public:
    void start_query(const Regions& regions, int reach);

    // Found when first asked for, in O(the region's bounding box), and kept for as long as the map is the same.
    const Border& of(RegionId region);

    // Whether the agent can be there: in no obstacle but these (sorted).
    bool stands(Vertex v, std::span<const ObstacleId> open) const;

  private:
    Border trace(RegionId region) const;
    std::vector<Vertex> points_of(RegionId region) const;
    bool free_between(Vertex a, Vertex b) const;

    const Regions* regions_ = nullptr;
    const Map* map_ = nullptr;  // of the regions
    int reach_ = 0;
    std::shared_ptr<const void> identity_;
    std::unordered_map<std::uint32_t, Border> borders_;  // by region
};

}  // namespace waybreaker::crossing
