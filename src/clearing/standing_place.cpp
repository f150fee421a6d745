#include "clearing/standing_place.hpp"

#include <algorithm>
#include <cmath>
#include <compare>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <unordered_map>
#include <vector>

#include "map/gap.hpp"
#include "map/line_of_sight.hpp"

namespace waybreaker::clearing {
namespace {

// Of A*: the least that a drive over that cell to the obstacle can be, and what is driven. Equal ones by cell.
struct Node {
    double least = 0;
    double driven = 0;
    Cell at;
    friend auto operator<=>(const Node&, const Node&) = default;
};

// The box of an obstacle, larger by so much on each side, holds all places to breach it from.
double margin_of_places(const Agent& vehicle) {
    return vehicle.body.reach() + vehicle.reach + 1;
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

// From where on the way is shortest on the whole, and how long it is; infinity where there is no such place.
struct Standing {
    Cell at;
    double whole = std::numeric_limits<double>::infinity();
};

// `way_on`: from a place on, never less than `least_on`.
template <class WayOn>
Standing nearest(const OpenedMap& map, const Agent& vehicle, Cell from, ObstacleId obstacle, WayOn way_on,
                 double least_on) {
    const LineOfSight sight(map, vehicle.body);
    const Box& box = map.map().obstacle(obstacle).bounds;
    const double most = vehicle.body.reach() + vehicle.reach;
    const auto to_places = [&](Cell c) { return std::max(gap(box, c) - margin_of_places(vehicle), 0.0); };
    const auto index = [&](Cell c) { return std::size_t(c.y) * std::size_t(map.width()) + std::size_t(c.x); };
    std::priority_queue<Node, std::vector<Node>, std::greater<>> open;
    std::unordered_map<std::size_t, double> driven;
    const auto reached = [&](Cell c, double length) {
        const auto [known, is_new] = driven.try_emplace(index(c), length);
        if (!is_new && known->second <= length) return;
        known->second = length;
        open.push({length + to_places(c), length, c});
    };
    reached(from, 0);
    Standing best;
    while (!open.empty()) {
        const Node node = open.top();
        const Cell cell = node.at;
        open.pop();
        if (node.least + least_on >= best.whole) break;
        if (node.driven > driven.at(index(cell))) continue;
        const double whole = node.driven + way_on(cell);
        const bool is_place = to_places(cell) == 0 && is_near(map.map(), cell, obstacle, most);
        if (is_place && whole < best.whole) best = {cell, whole};
        for (int dy = -1; dy <= 1; ++dy) {
            for (int dx = -1; dx <= 1; ++dx) {
                const Cell to{cell.x + dx, cell.y + dy};
                if (to == cell || !map.map().grid().contains(to) || !sight.fits(to) || !sight.clear(cell, to)) continue;
                reached(to, node.driven + std::hypot(dx, dy));
            }
        }
    }
    return best;
}

}  // namespace

std::optional<Cell> standing_place(const OpenedMap& map, const Agent& vehicle, Cell from, ObstacleId obstacle,
                                   std::optional<Point> next) {
    Standing found;
    if (next) {
        const Point to = *next;
        const double apart = gap(map.map().obstacle(obstacle).bounds, to) - margin_of_places(vehicle);
        const auto way_on = [to](Cell c) { return distance(Point(c), to); };
        found = nearest(map, vehicle, from, obstacle, way_on, std::max(apart, 0.0));
    } else {
        found = nearest(
            map, vehicle, from, obstacle, [](Cell) { return 0.0; }, 0);
    }
    return std::isfinite(found.whole) ? std::optional(found.at) : std::nullopt;
}

}  // namespace waybreaker::clearing
