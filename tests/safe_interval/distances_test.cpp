// Distances to a goal against Dijkstra over all cells that see each other.
#include "safe_interval/distances.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>

#include "random_map.hpp"
#include "waybreaker/advanced/search.hpp"

namespace waybreaker {
namespace {

// The shortest any-angle path through centres, by brute force.
std::vector<double> shortest(const PlainMap& plain, const OpenedMap& map, const Body& body, Cell goal) {
    const std::vector<Cell> cells = plain.free_cells();
    std::vector<double> length(cells.size(), std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < cells.size(); ++i) {
        if (cells[i] == goal && fits(map, goal, body)) length[i] = 0;
    }
    for (bool changed = true; changed;) {
        changed = false;
        for (std::size_t a = 0; a < cells.size(); ++a) {
            if (std::isinf(length[a])) continue;
            for (std::size_t b = 0; b < cells.size(); ++b) {
                const double by = length[a] + distance(cells[a], cells[b]);
                if (by + 1e-12 >= length[b] || !line_of_sight(map, cells[a], cells[b], body)) continue;
                length[b] = by;
                changed = true;
            }
        }
    }
    return length;
}

RC_GTEST_PROP(Distances, AreThoseOfRealWays, ()) {
    const PlainMap plain = *random_map(12, 12);
    const Map map(plain.grid());
    const OpenedMap opened(map);
    const Body body{.radius = *rc::gen::element(0.3, 0.5, 1.2)};
    const Cell goal = any_free_cell(plain);
    const LineOfSight sight(opened, body);
    RC_PRE(sight.fits(goal));
    safe_interval::OpenSteps open_steps(map.width(), map.height());
    const safe_interval::Distances distances(opened, sight, open_steps, std::array{goal}, safe_interval::everywhere,
                                             Deadline());
    const std::vector<Cell> cells = plain.free_cells();
    const std::vector<double> least = shortest(plain, opened, body, goal);
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const double found = distances.to_goal(cells[i]);
        RC_ASSERT(std::isinf(found) == std::isinf(least[i]));
        if (std::isinf(found)) continue;
        RC_ASSERT(found >= least[i] - 1e-3);
        RC_ASSERT(found <= 1.2 * least[i] + 1e-3);
        // The way on is legal, and as long as it says.
        double driven = 0;
        Cell at = cells[i];
        for (int moves = 0; at != goal; ++moves) {
            RC_ASSERT(moves < 200);
            const Cell next = distances.next(at);
            RC_ASSERT(line_of_sight(opened, at, next, body));
            driven += distance(at, next);
            at = next;
        }
        RC_ASSERT(driven <= found + 1e-2);
    }
    RC_ASSERT(std::isinf(distances.to_goal({-1, 0})));
    RC_ASSERT(std::isinf(distances.to_goal({0, plain.height})));
}

// Whoever is on the way has at most the rest of it to go, though Theta* alone would find something longer.
RC_GTEST_PROP(Distances, AreNoLongerThanTheWay, ()) {
    const PlainMap plain = *random_map(12, 12);
    const Map map(plain.grid());
    const OpenedMap opened(map);
    const LineOfSight sight(opened, {});
    std::vector<Cell> way{any_free_cell(plain)};
    for (int legs = *number(0, 4); legs > 0; --legs) {
        const Cell next = any_free_cell(plain);
        if (next != way.back() && sight.clear(way.back(), next)) way.push_back(next);
    }
    double length = 0;
    for (std::size_t i = 1; i < way.size(); ++i) length += distance(way[i - 1], way[i]);
    const safe_interval::Region region = *rc::gen::element(safe_interval::everywhere, safe_interval::along_the_path,
                                                           safe_interval::Region{std::max(length, 1.0)});
    safe_interval::OpenSteps open_steps(map.width(), map.height());
    const safe_interval::Distances distances(opened, sight, open_steps, way, region, Deadline());
    double rest = 0;
    for (std::size_t i = way.size(); i-- > 0;) {
        if (i + 1 < way.size()) rest += distance(way[i], way[i + 1]);
        RC_ASSERT(double(distances.to_goal(way[i])) <= rest + 1e-3);
    }
}

}  // namespace
}  // namespace waybreaker
