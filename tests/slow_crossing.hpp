// Crossing paths, slow and obvious, to hold the fast search against: a graph over every place a path could bend at, an
// edge between any two of them, each edge tested against every cell in integers, and one Dijkstra for every set of
// obstacles. Shares nothing with src/.
//
// What a path may do follows from what stands: for the square the open 2 x 2 boxes around the centres of standing cells
// are closed, for the point the open cells and the common border of two standing cells side by side (or of a standing
// cell and the map's edge); for the relaxed body, a point that stands for a disc, also the place where two standing
// cells touch at a corner. For a wider disc the cells around a standing one are closed as well: for the square those at
// whose centre the disc would meet it, for the relaxed those that are in the disc's way from corner to corner.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "plain_map.hpp"
#include "slow_sight.hpp"
#include "waybreaker/advanced/crossing.hpp"

namespace waybreaker::slow {

// A set of obstacles; bit `id`. Maps with more than 62 of them are not for these tests.
using Set = std::uint64_t;
inline constexpr std::size_t most_obstacles = 62;

inline Set set_of(std::span<const ObstacleId> ids) {
    Set set = 0;
    for (const ObstacleId id : ids) set |= Set{1} << id.value;
    return set;
}

// All sets of at most `most` of the candidates, small ones first.
inline std::vector<Set> subsets(Set candidates, int most) {
    std::vector<Set> sets{0};
    for (std::size_t i = 0; i < sets.size(); ++i) {
        if (std::popcount(sets[i]) == most) break;
        for (Set rest = candidates & ~(std::bit_ceil(sets[i] + 1) - 1); rest != 0; rest &= rest - 1) {
            sets.push_back(sets[i] | (rest & -rest));
        }
    }
    return sets;
}

// Whether the segment a-b meets the open box around `at`: it does unless a line along a side, or its own, parts them.
inline bool meets_box(Point a, Point b, Point at, std::int64_t half_side) {
    if (std::max(a.x, b.x) <= at.x - half_side || std::min(a.x, b.x) >= at.x + half_side) return false;
    if (std::max(a.y, b.y) <= at.y - half_side || std::min(a.y, b.y) >= at.y + half_side) return false;
    bool left = false;
    bool right = false;
    for (const std::int64_t dx : {-half_side, half_side}) {
        for (const std::int64_t dy : {-half_side, half_side}) {
            const std::int64_t side = cross(a, b, {at.x + dx, at.y + dy});
            left = left || side < 0;
            right = right || side > 0;
        }
    }
    return left && right;
}

inline constexpr Set edge = Set{1} << 63;  // of the map: never gone

// The obstacles that must be gone before an agent can be at a cell.
inline Set needed(const PlainMap& map, const Body& body, bool relaxed, Cell at) {
    const auto closes = [&](Cell blocked) {
        const double dx = std::abs(at.x - blocked.x);
        const double dy = std::abs(at.y - blocked.y);
        if (dx == 0 && dy == 0) return true;
        if (relaxed || body.is_point()) return std::hypot(dx, dy) <= body.reach();
        return std::hypot(std::max(dx - 0.5, 0.0), std::max(dy - 0.5, 0.0)) < body.radius;
    };
    Set all = 0;
    const int margin = int(body.reach()) + 1;
    for (int y = at.y - margin; y <= at.y + margin; ++y) {
        for (int x = at.x - margin; x <= at.x + margin; ++x) {
            const Cell c{x, y};
            if (map.blocked(c) && closes(c)) all |= map.contains(c) ? Set{1} << map.at(c) : edge;
        }
    }
    return all;
}

class CrossingOracle {
  public:
    static constexpr double nowhere = std::numeric_limits<double>::infinity();

    CrossingOracle(PlainMap map, Body body, bool relaxed, Cell start, Cell goal)
        : map_(std::move(map)),
          square_(!relaxed && !body.is_point()),
          pinched_(relaxed && body.radius > 0 && body.radius < 1),
          start_(start),
          goal_(goal),
          bends_{slow::centre(start), slow::centre(goal)} {
        for (const Cell c : map_.cells()) needed_.push_back(needed(map_, body, relaxed, c));
        for (std::int64_t y = square_ ? 0 : -1; y < 2 * map_.height; y += 2) {
            for (std::int64_t x = square_ ? 0 : -1; x < 2 * map_.width; x += 2) bends_.push_back({x, y});
        }
        demands_.resize(bends_.size());
        for (std::size_t i = 0; i < bends_.size(); ++i) {
            for (std::size_t j = 0; j < i; ++j) demands_[i].push_back(demands(bends_[i], bends_[j]));
        }
    }

    // What has to go before a path may lead straight from a to b: of each of these sets one obstacle at least.
    std::vector<Set> demands(Point a, Point b) const {
        std::vector<Set> all;
        for (const Cell c : map_.cells()) {
            if (at(c) == 0) continue;
            if (meets_box(a, b, slow::centre(c), square_ ? 2 : 1)) {
                for (const Set own : each(at(c))) all.push_back(own);
            }
            if (square_) continue;
            for (const Cell side : {Cell{c.x - 1, c.y}, Cell{c.x + 1, c.y}, Cell{c.x, c.y - 1}, Cell{c.x, c.y + 1}}) {
                if (at(side) == 0 || !slides_between(a, b, c, side)) continue;
                for (const Set own : each(at(c))) {
                    for (const Set other : each(at(side))) all.push_back(own | other);
                }
            }
        }
        if (pinched_) {
            const std::int64_t parts = std::gcd(b.x - a.x, b.y - a.y);
            for (std::int64_t k = 1; k < parts; ++k) {
                const Point place{a.x + (b.x - a.x) / parts * k, a.y + (b.y - a.y) / parts * k};
                for (const Set own : demands_of_turn(a, place, b)) all.push_back(own);
            }
        }
        std::sort(all.begin(), all.end());
        all.erase(std::unique(all.begin(), all.end()), all.end());
        return all;
    }

    // What has to go before a path may lead from a past b, where it may turn, to c.
    std::vector<Set> demands_of_turn(Point a, Point b, Point c) const {
        std::vector<Set> all;
        if (!pinched_ || b.x % 2 == 0 || b.y % 2 == 0) return all;
        for (const std::int64_t x : {-1, 1}) {  // from the cell around b on one side of a pair to that on the other
            const bool there = towards(b, a, x, 1) && towards(b, c, -x, -1);
            const bool back = towards(b, c, x, 1) && towards(b, a, -x, -1);
            if (!there && !back) continue;
            const Cell one = beside(b, -x, 1);
            const Cell other = beside(b, x, -1);
            if (!map_.contains(one) || !map_.contains(other) || at(one) == 0 || at(other) == 0) continue;
            all.push_back(at(one) | at(other));
        }
        return all;
    }

    // The shortest path when those obstacles are gone. Where two standing cells pinch a place it is two: on either
    // side.
    double shortest(Set gone) const {
        if (stands(start_, gone) || stands(goal_, gone)) return nowhere;
        std::vector<double> lengths(2 * bends_.size(), nowhere);
        std::vector<bool> done(lengths.size());
        lengths[0] = 0;
        while (true) {
            std::size_t next = 2;
            for (std::size_t i = 0; i < lengths.size(); ++i) {
                if (!done[i] && lengths[i] < lengths[next]) next = i;
            }
            if (next == 2) return lengths[2];
            done[next] = true;
            for (std::size_t i = 0; i < bends_.size(); ++i) {
                if (side(bends_[next / 2], bends_[i], gone) != next % 2) continue;
                double& known = lengths[2 * i + side(bends_[i], bends_[next / 2], gone)];
                const double through = lengths[next] + length(bends_[next / 2], bends_[i]);
                if (through < known && met(between(next / 2, i), gone)) known = through;
            }
        }
    }

    static bool met(const std::vector<Set>& demands, Set gone) {
        return std::all_of(demands.begin(), demands.end(), [&](Set demand) { return (demand & gone) != 0; });
    }

  private:
    static double length(Point a, Point b) { return std::hypot(double(a.x - b.x), double(a.y - b.y)) / 2; }

    bool stands(Cell c, Set gone) const { return (at(c) & ~gone) != 0; }

    static Cell beside(Point corner, std::int64_t x, std::int64_t y) {
        return {int((corner.x + x) / 2), int((corner.y + y) / 2)};
    }
    // Whether the way from a corner to a place leads into the cell there, or along it.
    static bool towards(Point corner, Point to, std::int64_t x, std::int64_t y) {
        return (to.x - corner.x) * x >= 0 && (to.y - corner.y) * y >= 0;
    }
    // On which side of a pinched place one is who comes from there, or goes there.
    std::size_t side(Point place, Point other, Set gone) const {
        if (!pinched_ || place.x % 2 == 0 || place.y % 2 == 0) return 0;
        for (const std::int64_t x : {-1, 1}) {
            const Cell one = beside(place, -x, 1);
            const Cell two = beside(place, x, -1);
            const bool pinch = map_.contains(one) && map_.contains(two) && stands(one, gone) && stands(two, gone);
            if (pinch && !stands(beside(place, x, 1), gone) && !stands(beside(place, -x, -1), gone)) {
                return towards(place, other, x, 1) ? 1 : 0;
            }
        }
        return 0;
    }

    // What must be gone at a cell.
    Set at(Cell c) const { return map_.contains(c) ? needed_[map_.index(c)] : edge; }
    static std::vector<Set> each(Set set) {
        std::vector<Set> members;
        for (; set != 0; set &= set - 1) members.push_back(set & -set);
        return members;
    }

    // Whether the segment runs along the border between two cells side by side, for more than a point of it.
    static bool slides_between(Point a, Point b, Cell c, Cell side) {
        const Point p{c.x + side.x, c.y + side.y};  // the middle of the border
        const bool upright = c.y == side.y;
        const std::int64_t low = upright ? std::min(a.y, b.y) : std::min(a.x, b.x);
        const std::int64_t high = upright ? std::max(a.y, b.y) : std::max(a.x, b.x);
        const std::int64_t along = upright ? p.y : p.x;
        const bool on_line = upright ? a.x == p.x && b.x == p.x : a.y == p.y && b.y == p.y;
        return on_line && low < along + 1 && high > along - 1;
    }

    const std::vector<Set>& between(std::size_t i, std::size_t j) const {
        return demands_[std::max(i, j)][std::min(i, j)];
    }

    PlainMap map_;
    std::vector<Set> needed_;  // by cell
    bool square_;
    bool pinched_;
    Cell start_;
    Cell goal_;
    std::vector<Point> bends_;                            // the start first, then the goal
    std::vector<std::vector<std::vector<Set>>> demands_;  // of all pairs of bends
};

}  // namespace waybreaker::slow
