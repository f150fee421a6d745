// Distances to the goal for an agent that is alone: the heuristic, and the path on when nobody is in the way.
#pragma once

#include <compare>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "core/stopwatch.hpp"
#include "map/line_of_sight.hpp"
#include "safe_interval/open_steps.hpp"
#include "safe_interval/tuning.hpp"

namespace waybreaker::safe_interval {

// Cells whose distances are asked for: next to a path, or wherever paths between its ends go that are up to so many
// cells long.
struct Region {
    double longest = 0;
    friend auto operator<=>(const Region&, const Region&) = default;
};
inline constexpr Region along_the_path{0};
inline constexpr Region everywhere{std::numeric_limits<double>::infinity()};

// Any-angle distances from every cell of a region, by Lazy Theta* from the goal without a heuristic (Nash, Koenig,
// Tovey 2010); but a cell looks at all its neighbours when it is settled, and those of a known way follow it unless
// they find a shorter one. A length is that of a real way, so it is never too small, and may be a little too large.
//
// The region is made of tiles.
class Distances {
  public:
    static constexpr float unknown = std::numeric_limits<float>::infinity();

    // To the end of a legal way, perhaps of one cell: for all cells from which that can be reached, or for those in
    // tiles that lie next to one on the way. Time O(n log n) in the cells of the region, and a few lines of sight for
    // each; not complete if the deadline passes.
    Distances(const OpenedMap& map, const LineOfSight& sight, OpenSteps& open_steps, std::span<const Cell> way,
              Region region, const Deadline& deadline);

    bool complete() const { return complete_; }

    // `unknown` outside the region.
    float to_goal(Cell c) const {
        const std::uint32_t at = index(c);
        return at == none ? unknown : entries_[at].length;
    }
    // The next bend of the path from `c` to the goal, in sight of it. REQUIRES: to_goal(c) is known.
    Cell next(Cell c) const { return entries_[index(c)].next; }

    static constexpr std::uint32_t none = UINT32_MAX;

    // Number of a cell of the region, below size(); `none` outside. The cell may lie off the map.
    std::uint32_t index(Cell c) const {
        if (c.x < left_ || c.y < top_ || c.x >= right_ || c.y >= bottom_) return none;
        const auto x = unsigned(c.x - left_);
        const auto y = unsigned(c.y - top_);
        const std::uint32_t first = tiles_[y / side * columns_ + x / side];
        return first == none ? none : first + y % side * side + x % side;
    }
    std::size_t size() const { return entries_.size(); }
    std::size_t bytes() const { return tiles_.size() * sizeof(std::uint32_t) + entries_.size() * sizeof(Entry); }

  private:
    static constexpr int side = tuning::tile_side;

    struct Entry {
        float length = unknown;
        Cell next;
    };
    class Flood;

    void add_tile(std::uint32_t number);
    void add_tiles_near(std::span<const Cell> way);
    void add_tiles_within(double longest, Cell start, Cell goal);

    // The box of the region.
    int left_ = 0;
    int top_ = 0;
    int right_ = 0;
    int bottom_ = 0;
    unsigned columns_ = 1;              // of tiles
    std::vector<std::uint32_t> tiles_;  // the first entry of each
    std::vector<Entry> entries_;
    bool complete_ = false;
};

}  // namespace waybreaker::safe_interval
