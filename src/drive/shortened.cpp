#include "drive/shortened.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <utility>

#include "map/line_of_sight.hpp"

namespace waybreaker {
namespace {

// Cells that a bend is moved at once: farther where nearer ones gain nothing.
constexpr int nearest = 2;
constexpr int farthest = 3;
constexpr double least_gain = 1e-9;  // in cells

// The best place for a bend near to where it is, or exactly so many cells away, its neighbours staying where they are.
Cell best_place(const LineOfSight& sight, const OpenedMap& map, Cell before, Cell bend, Cell after, int within) {
    const auto detour = [&](Cell c) { return distance(before, c) + distance(c, after); };
    Cell best = bend;
    double least = detour(bend) - least_gain;
    for (int dy = -within; dy <= within; ++dy) {
        for (int dx = -within; dx <= within; ++dx) {
            if (within > nearest && std::max(std::abs(dx), std::abs(dy)) < within) continue;
            const Cell c{bend.x + dx, bend.y + dy};
            if (!map.map().grid().contains(c) || detour(c) >= least) continue;
            if (!sight.fits(c) || !sight.clear(before, c) || !sight.clear(c, after)) continue;
            best = c;
            least = detour(c) - least_gain;
        }
    }
    return best;
}

// One round over all bends; whether it changed any.
bool shorten(const LineOfSight& sight, const OpenedMap& map, std::vector<Point>& path, int within) {
    bool changed = false;
    for (std::size_t i = 1; i + 1 < path.size(); ++i) {
        const Cell before = cell_of(path[i - 1]);
        const Cell bend = cell_of(path[i]);
        const Cell after = cell_of(path[i + 1]);
        if (within == nearest && sight.clear(before, after)) {
            path.erase(path.begin() + std::ptrdiff_t(i--));
            changed = true;
            continue;
        }
        const Cell better = best_place(sight, map, before, bend, after, within);
        if (better == bend) continue;
        path[i] = Point(better);
        changed = true;
    }
    return changed;
}

}  // namespace

Cell cell_of(Point p) {
    return {int(std::lround(p.x)), int(std::lround(p.y))};
}

std::vector<Point> shortened(const OpenedMap& map, const Body& body, std::vector<Point> path) {
    const LineOfSight sight(map, body);
    for (int within = nearest; within <= farthest;) {
        const bool changed = shorten(sight, map, path, within);
        within = changed ? nearest : within + 1;
    }
    return path;
}

}  // namespace waybreaker
