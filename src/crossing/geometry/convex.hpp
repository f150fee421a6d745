// Convex: obstacles that leave a convex piece of free ground when they are removed.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "crossing/geometry/lattice.hpp"
#include "crossing/geometry/regions.hpp"

namespace waybreaker::crossing {

// An obstacle is one of them if no other has a cell in the box around it. Between two places where a shortest path
// crosses the obstacle it stays in the grown box, and crosses nothing else there: docs/exact.md.
class Convex {
  public:
    // Keeps the regions for as long as the query lasts; what is known of a map is kept for the next.
    void start_query(const Regions& regions, int reach);

    // Whether no shortest path that crosses the obstacle before v is in its way after v again.
    bool left(ObstacleId obstacle, Vertex v) {
        const Box box = regions_->bounds(obstacle);
        // The square may go around a cell beside the box on either side for the same, but no farther.
        const int around = reach_ == 1 ? 1 : 4;
        const bool outside = v.x < 2 * box.min.x - around || v.x > 2 * box.max.x + around ||
                             v.y < 2 * box.min.y - around || v.y > 2 * box.max.y + around;
        return outside && alone(obstacle);
    }

  private:
    enum class Known : std::uint8_t { unknown, alone, not_alone };

    // Whether nothing else is in the obstacle's box.
    bool alone(ObstacleId obstacle) {
        Known& known = known_[obstacle.value];
        if (known == Known::unknown) known = look(obstacle) ? Known::alone : Known::not_alone;
        return known == Known::alone;
    }
    bool look(ObstacleId obstacle) const;

    const Regions* regions_ = nullptr;
    std::shared_ptr<const void> identity_;  // of the map of the regions
    int reach_ = 1;                         // half cells
    std::vector<Known> known_;              // by obstacle
};

}  // namespace waybreaker::crossing
