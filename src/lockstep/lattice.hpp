// The cells on which a body fits, and the steps between cells side by side.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include "map/line_of_sight.hpp"

namespace waybreaker::lockstep {

// The number of a cell.
using Site = std::uint32_t;
inline constexpr Site nowhere = UINT32_MAX;

// Right, left, down, up.
using Direction = unsigned;
inline constexpr Direction directions = 4;
inline constexpr std::array<Cell, directions> ahead{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};
constexpr Direction opposite(Direction d) {
    return d ^ 1U;
}

// A bit for each site.
using Word = std::uint64_t;
using SiteSet = std::vector<Word>;
inline bool contains(const Word* set, Site site) {
    return (set[site / 64] >> site % 64 & 1U) != 0;
}
inline void insert(Word* set, Site site) {
    set[site / 64] |= Word{1} << site % 64;
}
inline void erase(Word* set, Site site) {
    set[site / 64] &= ~(Word{1} << site % 64);
}

class Lattice {
  public:
    Lattice(const OpenedMap& map, const Body& body);

    // Rows are filled up to whole words.
    Site size() const { return size_; }
    std::size_t words() const { return size_ / 64; }
    std::size_t row_words() const { return stride_ / 64; }

    Site site(Cell c) const { return Site(c.y) * stride_ + Site(c.x); }
    Cell cell(Site site) const { return {int(site % stride_), int(site / stride_)}; }

    // REQUIRES: there is such a site.
    Site next(Site from, Direction d) const {
        return from + Site(ahead[d].x) + Site(ahead[d].y) * stride_;  // modulo 2^32
    }
    bool open(Site from, Direction d) const { return (steps_[from] >> d & 1U) != 0; }
    // Whether one step leads away from there.
    bool is_end(Site site) const { return std::has_single_bit(steps_[site]); }
    // Where a step in that direction can end.
    const Word* ends(Direction d) const { return ends_[d].data(); }

    // The steps that are left to a goal, for each site; `unreachable` where there is no way.
    static constexpr std::uint32_t unreachable = UINT32_MAX;
    std::vector<std::uint32_t> distances_to(Site goal) const;

  private:
    Site stride_;
    Site size_;
    std::vector<std::uint8_t> steps_;  // a bit for each direction
    std::array<SiteSet, directions> ends_;
};

}  // namespace waybreaker::lockstep
