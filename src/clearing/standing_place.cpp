#include "clearing/standing_place.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>
#include <tuple>
#include <unordered_map>
#include <vector>

#include "map/line_of_sight.hpp"

namespace waybreaker::clearing {
namespace {

double to_box(Point p, const Box& box) {
    const double dx = std::max({box.min.x - p.x, p.x - box.max.x, 0.0});
    const double dy = std::max({box.min.y - p.y, p.y - box.max.y, 0.0});
    return std::hypot(dx, dy);
}

// Whether a cell of the obstacle is at most so far from the centre of a cell.
bool is_near(const Map& map, Cell at, ObstacleId obstacle, double most) {
    const int side = int(std::ceil(most + 0.5));
    for (int y = std::max(at.y - side, 0); y <= std::min(at.y + side, map.height() - 1); ++y) {
        for (int x = std::max(at.x - side, 0); x <= std::min(at.x + side, map.width() - 1); ++x) {
            if (map.obstacle_at({x, y}) != obstacle) continue;
            const double dx = std::max(std::abs(at.x - x) - 0.5, 0.0);
            const double dy = std::max(std::abs(at.y - y) - 0.5, 0.0);
            if (std::hypot(dx, dy) <= most) return true;
        }
    }
    return false;
}

}  // namespace

std::optional<Cell> standing_place(const OpenedMap& map, const Body& body, Cell from, ObstacleId obstacle,
                                   std::optional<Point> next) {
    const LineOfSight sight(map, body);
    const Box& box = map.map().obstacle(obstacle).bounds;
    const double most = body.reach() + reach;
    const double grown = most + 1;  // the box of the obstacle by so much holds all places
    const auto to_places = [&](Cell c) { return std::max(to_box(c, box) - grown, 0.0); };
    const double least_on = next ? std::max(to_box(*next, box) - grown, 0.0) : 0;  // from any place to the next one
    const auto index = [&](Cell c) { return std::size_t(c.y) * std::size_t(map.width()) + std::size_t(c.x); };
    // A*: the least that a drive over a cell to the obstacle can be, then what is driven. Equal ones in scan order.
    using Entry = std::tuple<double, double, std::size_t, Cell>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    std::unordered_map<std::size_t, double> driven;
    const auto reached = [&](Cell c, double length) {
        const auto [known, is_new] = driven.try_emplace(index(c), length);
        if (!is_new && known->second <= length) return;
        known->second = length;
        open.emplace(length + to_places(c), length, index(c), c);
    };
    reached(from, 0);
    std::optional<Cell> best;
    double shortest = std::numeric_limits<double>::infinity();
    while (!open.empty()) {
        const auto [least, length, at, cell] = open.top();
        open.pop();
        if (least + least_on >= shortest) break;
        if (length > driven.at(at)) continue;
        const double whole = length + (next ? distance(Point(cell), *next) : 0);
        if (whole < shortest && to_box(cell, box) <= grown && is_near(map.map(), cell, obstacle, most)) {
            best = cell;
            shortest = whole;
        }
        for (int dy = -1; dy <= 1; ++dy) {
            for (int dx = -1; dx <= 1; ++dx) {
                const Cell to{cell.x + dx, cell.y + dy};
                if (to == cell || !map.map().grid().contains(to) || !sight.fits(to) || !sight.clear(cell, to)) continue;
                reached(to, length + std::hypot(dx, dy));
            }
        }
    }
    return best;
}

}  // namespace waybreaker::clearing
