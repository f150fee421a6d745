#include "drive/shortened.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "map/line_of_sight.hpp"

namespace waybreaker {
namespace {

constexpr int farthest = 2;          // cells that a bend is moved at once
constexpr double least_gain = 1e-9;  // in cells

// The best place for a bend near to where it is, its neighbours staying where they are.
Cell best_near(const LineOfSight& sight, const OpenedMap& map, Cell before, Cell bend, Cell after) {
    const auto detour = [&](Cell c) { return distance(before, c) + distance(c, after); };
    Cell best = bend;
    double least = detour(bend) - least_gain;
    for (int dy = -farthest; dy <= farthest; ++dy) {
        for (int dx = -farthest; dx <= farthest; ++dx) {
            const Cell c{bend.x + dx, bend.y + dy};
            if (!map.map().grid().contains(c) || detour(c) >= least) continue;
            if (!sight.fits(c) || !sight.clear(before, c) || !sight.clear(c, after)) continue;
            best = c;
            least = detour(c) - least_gain;
        }
    }
    return best;
}

}  // namespace

Cell cell_of(Point p) {
    return {int(std::lround(p.x)), int(std::lround(p.y))};
}

std::vector<Point> shortened(const OpenedMap& map, const Body& body, std::vector<Point> path) {
    const LineOfSight sight(map, body);
    for (bool changed = true; changed;) {
        changed = false;
        for (std::size_t i = 1; i + 1 < path.size(); ++i) {
            const Cell before = cell_of(path[i - 1]);
            const Cell bend = cell_of(path[i]);
            const Cell after = cell_of(path[i + 1]);
            if (sight.clear(before, after)) {
                path.erase(path.begin() + std::ptrdiff_t(i--));
                changed = true;
                continue;
            }
            const Cell better = best_near(sight, map, before, bend, after);
            if (better == bend) continue;
            path[i] = Point(better);
            changed = true;
        }
    }
    return path;
}

}  // namespace waybreaker
