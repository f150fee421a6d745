// Open steps: the neighbours of a cell that an agent can step to. Each search asks for the same cells, so sight is
// looked at once.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "map/line_of_sight.hpp"
#include "safe_interval/tuning.hpp"

namespace waybreaker::safe_interval {

// To the eight neighbours of a cell.
inline constexpr std::array<Cell, 8> steps{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {1, -1}, {-1, 1}, {-1, -1}}};

// On one map, for one body. Memory only for the tiles that are asked for.
class OpenSteps {
  public:
    OpenSteps(int width, int height)
        : width_(width),
          height_(height),
          columns_(std::size_t(width - 1) / side + 1),
          tiles_(columns_ * (std::size_t(height - 1) / side + 1)) {}

    // Calls visit(neighbour) for those that the agent fits on and sees from a cell where it fits, in the order of
    // `steps`. The sight is that of the map and the body, each time.
    template <class Visit>
    void from(Cell cell, const LineOfSight& sight, Visit visit) {
        const auto x = std::size_t(cell.x);
        const auto y = std::size_t(cell.y);
        std::vector<std::uint16_t>& tile = tiles_[y / side * columns_ + x / side];
        if (tile.empty()) tile.resize(side * side);
        std::uint16_t& open = tile[y % side * side + x % side];
        if (open == 0) open = look(cell, sight);
        for (unsigned k = 0; k < steps.size(); ++k) {
            if ((open >> k & 1U) != 0) visit(Cell{cell.x + steps[k].x, cell.y + steps[k].y});
        }
    }

  private:
    static constexpr std::size_t side = tuning::step_tile_side;
    static constexpr std::uint16_t looked = 1U << steps.size();

    std::uint16_t look(Cell cell, const LineOfSight& sight) const {
        unsigned open = 0;
        for (unsigned k = 0; k < steps.size(); ++k) {
            const Cell to{cell.x + steps[k].x, cell.y + steps[k].y};
            if (to.x < 0 || to.y < 0 || to.x >= width_ || to.y >= height_) continue;
            if (sight.fits(to) && sight.clear(cell, to)) open |= 1U << k;
        }
        return std::uint16_t(open | looked);
    }

    int width_;
    int height_;
    std::size_t columns_;  // of tiles
    std::vector<std::vector<std::uint16_t>> tiles_;
};

}  // namespace waybreaker::safe_interval
