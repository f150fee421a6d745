#include "waybreaker/grid.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "map/map_size.hpp"
#include "map/require_on_map.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker {
namespace {

int checked_side(int width, int height) {
    require_size(width, height);
    return width;
}

// Transposes a 64 x 64 block of bits: bit c of block[r] goes to bit r of block[c]. (Hacker's Delight, 7-3.)
void transpose(std::array<std::uint64_t, 64>& block) {
    std::uint64_t mask = 0x00000000FFFFFFFFULL;
    for (unsigned half = 32; half != 0; half /= 2, mask ^= mask << half) {
        for (unsigned r = 0; r < 64; r = ((r | half) + 1) & ~half) {
            const std::uint64_t swap = ((block[r] >> half) ^ block[r | half]) & mask;
            block[r] ^= swap << half;
            block[r | half] ^= swap;
        }
    }
}

}  // namespace

Grid::Grid(int width, int height)
    : width_(checked_side(width, height)),
      height_(height),
      words_per_row_(std::size_t(width + 2 + 63) / 64),
      // Frame rows above and below, and a spare word for reads that start in the last one.
      words_(words_per_row_ * std::size_t(height + 2) + 1, ~std::uint64_t{0}) {
    for (int y = 0; y < height_; ++y) {
        std::uint64_t* words = mutable_row(y);
        std::fill(words, words + words_per_row_, 0);
        words[0] |= 1U;
        const std::size_t end = std::size_t(width_) + 1;
        words[end / 64] |= ~std::uint64_t{0} << (end % 64);
        for (std::size_t word = end / 64 + 1; word < words_per_row_; ++word) words[word] = ~std::uint64_t{0};
    }
}

void require_on_map(const Grid& grid, Cell c) {
    if (!grid.contains(c)) {
        throw InputError(ErrorCode::off_map, "",
                         "cell " + std::to_string(c.x) + "," + std::to_string(c.y) +
                             " is off the map: x goes from 0 to " + std::to_string(grid.width() - 1) +
                             ", y from 0 to " + std::to_string(grid.height() - 1));
    }
}

void Grid::set_blocked(Cell c, bool blocked) {
    require_on_map(*this, c);
    const std::size_t bit = std::size_t(c.x + 1);
    std::uint64_t& word = mutable_row(c.y)[bit / 64];
    const std::uint64_t mask = std::uint64_t{1} << (bit % 64);
    word = blocked ? word | mask : word & ~mask;
}

Grid Grid::transposed() const {
    Grid result(height_, width_);
    std::array<std::uint64_t, 64> block;
    // The frames of both grids are blocked, so the blocks can be moved frame and all.
    const int rows = height_ + 2;
    const int result_rows = width_ + 2;
    for (int block_y = 0; block_y < rows; block_y += 64) {
        for (std::size_t word = 0; word < words_per_row_; ++word) {
            for (int r = 0; r < 64; ++r) {
                block[std::size_t(r)] = block_y + r < rows ? row(block_y + r - 1)[word] : ~std::uint64_t{0};
            }
            transpose(block);
            const int first = int(word * 64);
            for (int r = 0; r < 64 && first + r < result_rows; ++r) {
                result.mutable_row(first + r - 1)[block_y / 64] = block[std::size_t(r)];
            }
        }
    }
    return result;
}

}  // namespace waybreaker
