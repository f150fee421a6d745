// Convex: obstacles that leave a convex piece of free ground when they are removed.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "crossing/lattice.hpp"
#include "crossing/regions.hpp"

namespace waybreaker::crossing {

// The box around a grown obstacle is such a piece if nothing else reaches into it. Between two places where a shortest
// path crosses the obstacle it stays in the box: the straight line between them is shorter than any way outside, and
// crosses nothing else. docs/exact.md.
class Convex {
  public:
    // Keeps the regions for as long as the query lasts; what is known of a map is kept for the next.
    void start_query(const Regions& regions, int reach);

    // Whether no shortest path that crosses the obstacle before v is in its way after v again.
    bool left(ObstacleId obstacle, Vertex v) {
        const Box box = regions_->bounds(obstacle);
        const bool outside = v.x < 2 * box.min.x - reach_ || v.x > 2 * box.max.x + reach_ ||
                             v.y < 2 * box.min.y - reach_ || v.y > 2 * box.max.y + reach_;
        return outside && alone(obstacle);
    }

  private:
    enum class Known : std::uint8_t { unknown, alone, not_alone };

    // Whether nothing else reaches into the obstacle's box.
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
