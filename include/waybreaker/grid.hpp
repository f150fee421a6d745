// Grid: which cells are blocked, one bit a cell.
//
//     Grid grid(64, 48);                  // width, height; every cell free
//     grid.set_blocked({10, 20}, true);
//     Map map(std::move(grid));           // label its obstacles: see map.hpp
//
// The bits of a row lie in 64-bit words with a frame of blocked bits around the map, so that the planners can look
// one cell past every edge and test a whole run of cells at once.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "waybreaker/cell.hpp"

namespace waybreaker {

// Largest side of a map, and most cells of one; readers refuse more before they allocate.
inline constexpr int max_side = 32768;
inline constexpr std::size_t max_cells = std::size_t{16384} * 16384;

class Grid {
  public:
    // All cells free. Throws InputError unless 1 <= width, height <= max_side and width * height <= max_cells.
    Grid(int width, int height);

    int width() const { return width_; }
    int height() const { return height_; }
    std::size_t cell_count() const { return std::size_t(width_) * std::size_t(height_); }
    bool contains(Cell c) const { return c.x >= 0 && c.x < width_ && c.y >= 0 && c.y < height_; }

    // Cells up to one step outside the map may be asked for; they are blocked.
    bool blocked(Cell c) const {
        const std::size_t bit = std::size_t(c.x + 1);
        return (row(c.y)[bit / 64] >> (bit % 64)) & 1U;
    }
    // Throws InputError if the cell is off the map.
    void set_blocked(Cell c, bool blocked);

    // The words of row y, -1 <= y <= height; cell x is bit x + 1. Two words more than the row needs can be read.
    const std::uint64_t* row(int y) const { return words_.data() + std::size_t(y + 1) * words_per_row_; }
    std::size_t words_per_row() const { return words_per_row_; }

    // The same map with x and y exchanged.
    Grid transposed() const;

    friend bool operator==(const Grid&, const Grid&) = default;

  private:
    std::uint64_t* mutable_row(int y) { return words_.data() + std::size_t(y + 1) * words_per_row_; }

    int width_;
    int height_;
    std::size_t words_per_row_;
    std::vector<std::uint64_t> words_;
};

}  // namespace waybreaker
