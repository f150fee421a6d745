// Line of sight of the ground agent on an opened map: exact, in integers (contract, section 2).
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "core/sweep.hpp"
#include "map/bit_run.hpp"
#include "waybreaker/body.hpp"

namespace waybreaker {

// Half the width of a disc's row that lies `v` cells from its middle: the open disc around the middle of cell 0, 0
// meets the cells (u, v) with |u| <= that; -1 if it meets none. The radius is given in thousandths of a cell.
int disc_row(std::int64_t thousandths, int v);

// Sight for one map and one way of moving; made once for a search. The map must outlive it.
class LineOfSight {
  public:
    LineOfSight(const OpenedMap& map, const Body& body);

    bool is_unit_disc() const { return model_ == Model::disc; }

    // Whether the agent can stand on a cell of the map.
    bool fits(Cell at) const { return model_ == Model::wide_disc ? wide_disc_fits(at) : !map_->blocked(at); }

    // As the function; for points and unit discs it is the cell itself.
    int disc_row(int v) const {
        const auto row = std::size_t(std::abs(v));
        return row < row_count_ ? rows_[row] : -1;
    }

    // Whether it can move straight between two cells of the map. Precondition: it fits on both.
    bool clear(Cell from, Cell to) const {
        const int dx = std::abs(to.x - from.x);
        const int dy = std::abs(to.y - from.y);
        switch (model_) {
            case Model::disc:
                return strip_clear(from, to, disc_reach(std::max(dx, dy), std::min(dx, dy)));
            case Model::point_cutting:
                return strip_clear(from, to, point_reach(std::max(dx, dy), std::min(dx, dy))) &&
                       passes_corners(from, to);
            case Model::point_squeezing:
                return strip_clear(from, to, point_reach(std::max(dx, dy), std::min(dx, dy)));
            case Model::wide_disc:
                return wide_disc_clear(from, to);
        }
        return false;
    }

  private:
    enum class Model { disc, point_cutting, point_squeezing, wide_disc };

    // No blocked cell within `reach` (core/sweep.hpp) of the segment, inside the box of its end points. Walks along the
    // shorter axis and tests a run of cells in each line: rows if the segment is flat, columns if it is steep.
    bool strip_clear(Cell from, Cell to, std::int64_t reach) const {
        return std::abs(to.x - from.x) >= std::abs(to.y - from.y)
                   ? lines_clear(from, to, reach, [this](int y) { return map_->row(y); })
                   : lines_clear({from.y, from.x}, {to.y, to.x}, reach, [this](int x) { return map_->column(x); });
    }

    template <class LineAt>
    static bool lines_clear(Cell from, Cell to, std::int64_t reach, LineAt line_at) {
        if (to.x < from.x) std::swap(from, to);
        const auto origin = unsigned(from.x + 1);  // bit of u = 0
        const int major = to.x - from.x;
        if (from.y == to.y) return !any_bit(line_at(from.y), origin, origin + unsigned(major));
        const int step = to.y > from.y ? 1 : -1;
        Sweep sweep(major, std::abs(to.y - from.y), reach);
        for (int y = from.y;; y += step, sweep.next_line()) {
            if (any_bit(line_at(y), origin + unsigned(sweep.first()), origin + unsigned(sweep.last()))) return false;
            if (y == to.y) return true;
        }
    }

    // Where the segment runs exactly through cell corners: not between two blocked cells.
    bool passes_corners(Cell from, Cell to) const;

    bool wide_disc_fits(Cell at) const;
    bool wide_disc_clear(Cell from, Cell to) const;

    const OpenedMap* map_;
    Model model_;
    std::int64_t radius_;                 // in thousandths of a cell
    std::array<std::int8_t, 34> rows_{};  // of the disc, from its middle on
    std::size_t row_count_ = 1;
};

}  // namespace waybreaker
