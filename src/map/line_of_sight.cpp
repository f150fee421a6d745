#include "map/line_of_sight.hpp"

#include <cassert>
#include <cmath>
#include <numeric>
#include <string>

#include "core/range.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker {
namespace {

constexpr std::int64_t unit = 1000;  // a radius is exact to thousandths of a cell
constexpr double max_radius = 32;    // keeps every product below inside 64 bits

std::int64_t floor_div(std::int64_t a, std::int64_t b) {
    return a / b - (a % b != 0 && (a < 0) != (b < 0) ? 1 : 0);
}
std::int64_t ceil_div(std::int64_t a, std::int64_t b) {
    return -floor_div(-a, b);
}

// How many cells beyond its own an interval of half width h around a cell centre reaches, for the largest k with
// (2k - 1) / 2 < h, given a test of that inequality.
template <class Reaches>
int cells_reached(Reaches reaches) {
    int k = 0;
    while (reaches(std::uint64_t(2 * k + 1))) ++k;
    return k;
}

}  // namespace

void validate(const Body& body) {
    if (body.radius != 0)
        require_range(body.radius, 1 / double(unit), max_radius, "the radius, in cells, unless it is 0,");
    require_enumerator(body.corners, Corners::squeeze, "what an agent does at corners");
    if (body.corners != Corners::none && body.radius != 0.5) {
        throw InputError(ErrorCode::contradiction, "",
                         "an agent that cuts corners or squeezes through is a point: leave its radius at 0.5");
    }
}

bool fits(const OpenedMap& map, Cell at, const Body& body) {
    validate(body);
    return map.map().grid().contains(at) && LineOfSight(map, body).fits(at);
}

bool line_of_sight(const OpenedMap& map, Cell from, Cell to, const Body& body) {
    validate(body);
    const Grid& grid = map.map().grid();
    if (!grid.contains(from) || !grid.contains(to)) return false;
    const LineOfSight sight(map, body);
    return sight.fits(from) && sight.fits(to) && sight.clear(from, to);
}

LineOfSight::LineOfSight(const OpenedMap& map, const Body& body) : map_(&map), radius_(body.thousandths()) {
    switch (body.passes()) {
        case Corners::none:
            model_ = 2 * radius_ == unit ? Model::disc : Model::wide_disc;
            break;
        case Corners::cut:
            model_ = Model::point_cutting;
            break;
        case Corners::squeeze:
            model_ = Model::point_squeezing;
            break;
    }
    if (model_ != Model::wide_disc) return;
    row_count_ = 0;
    for (int v = 0, row = 0; (row = waybreaker::disc_row(radius_, v)) >= 0; ++v) {
        assert(row_count_ < rows_.size());
        rows_[row_count_++] = std::int8_t(row);
    }
}

bool LineOfSight::passes_corners(Cell from, Cell to) const {
    const int dx = to.x - from.x;
    const int dy = to.y - from.y;
    const int repeats = std::gcd(dx, dy);
    if (dx == 0 || dy == 0 || dx / repeats % 2 == 0 || dy / repeats % 2 == 0) return true;  // meets no corner
    for (int k = 0; k < repeats; ++k) {
        // The corner at from + (k + 1/2) (dx, dy) / repeats lies between these two rows and columns.
        const auto left = int(floor_div(std::int64_t{2 * k + 1} * (dx / repeats) - 1, 2));
        const auto top = int(floor_div(std::int64_t{2 * k + 1} * (dy / repeats) - 1, 2));
        const bool falls = (dx > 0) == (dy > 0);  // the segment runs from upper left to lower right or back
        const Cell one{from.x + left + (falls ? 1 : 0), from.y + top};
        const Cell other{from.x + left + (falls ? 0 : 1), from.y + top + 1};
        if (map_->blocked(one) && map_->blocked(other)) return false;
    }
    return true;
}

int disc_row(std::int64_t thousandths, int v) {
    // (|u| - 1/2)^2 + (|v| - 1/2)^2 < R^2, a term being 0 for u = 0 or v = 0.
    const auto radius = std::uint64_t(thousandths);
    const std::uint64_t twice_v = v == 0 ? 0 : std::uint64_t(2 * std::abs(v) - 1);
    if (twice_v * unit >= 2 * radius) return v == 0 ? 0 : -1;
    return cells_reached(
        [&](std::uint64_t twice) { return (twice * twice + twice_v * twice_v) * unit * unit < 4 * radius * radius; });
}

bool LineOfSight::wide_disc_fits(Cell at) const {
    const auto row_fits = [&](int v) {
        const int reach = disc_row(v);
        const int y = at.y + v;
        // The edge of the map is a wall.
        if (y < 0 || y >= map_->height() || at.x - reach < 0 || at.x + reach >= map_->width()) return false;
        return !any_bit(map_->row(y), unsigned(at.x - reach + 1), unsigned(at.x + reach + 1));
    };
    for (int v = 0; v < int(row_count_); ++v) {
        if (!row_fits(v) || !row_fits(-v)) return false;
    }
    return true;
}

// The discs at both ends are clear, so only the rectangle between them is left: it meets a cell iff their shadows
// overlap on both axes, along the segment and across it (separating axes).
bool LineOfSight::wide_disc_clear(Cell from, Cell to) const {
    if (to.x < from.x) std::swap(from, to);
    const std::int64_t dx = to.x - from.x;
    const std::int64_t dy = std::abs(to.y - from.y);
    const int step = to.y >= from.y ? 1 : -1;
    const std::int64_t length2 = dx * dx + dy * dy;
    if (length2 == 0) return true;
    const auto radius = std::uint64_t(radius_);
    // Across: 2|c| <= reach, with 2 R L = sqrt(4 R^2 L^2) rounded up exactly.
    const std::uint64_t square = 4 * radius * radius * std::uint64_t(length2);
    auto strip = std::uint64_t(std::sqrt(double(square)) / double(unit));
    while (strip > 0 && (strip - 1) * unit * (strip - 1) * unit >= square) --strip;
    while (strip * unit * strip * unit < square) ++strip;
    const std::int64_t reach = dx + dy + std::int64_t(strip) - 1;
    // Axes: the rectangle leaves the box of its end points by R dy / L sideways and R dx / L up and down.
    const auto overhang = [&](std::int64_t side) {
        const std::uint64_t shadow = radius * std::uint64_t(side);
        return cells_reached([&](std::uint64_t twice) {
            return twice * twice * (unit / 2) * (unit / 2) * std::uint64_t(length2) < shadow * shadow;
        });
    };
    const int beside = overhang(dy);
    const int beyond = overhang(dx);
    for (std::int64_t v = -beyond; v <= dy + beyond; ++v) {
        std::int64_t first = -beside;
        std::int64_t last = dx + beside;
        // Across: |2 (u dy - v dx)| <= reach.
        if (dy > 0) {
            first = std::max(first, ceil_div(2 * v * dx - reach, 2 * dy));
            last = std::min(last, floor_div(2 * v * dx + reach, 2 * dy));
        } else if (2 * std::abs(v) * dx > reach) {
            continue;
        }
        // Along: 0 < 2 (u dx + v dy) + (dx + dy) and 2 (u dx + v dy) - (dx + dy) < 2 L^2.
        if (dx > 0) {
            first = std::max(first, ceil_div(1 - dx - dy - 2 * v * dy, 2 * dx));
            last = std::min(last, floor_div(2 * length2 + dx + dy - 1 - 2 * v * dy, 2 * dx));
        } else if (2 * v * dy + dy <= 0 || 2 * v * dy - dy >= 2 * length2) {
            continue;
        }
        if (first > last) continue;
        const std::int64_t y = from.y + step * v;
        if (y < 0 || y >= map_->height() || from.x + first < 0 || from.x + last >= map_->width()) return false;
        if (any_bit(map_->row(int(y)), unsigned(from.x + first + 1), unsigned(from.x + last + 1))) return false;
    }
    return true;
}

}  // namespace waybreaker
