// Shortened paths: legal, no longer, and no bend could be dropped or be better off at a place near to it.
#include "drive/shortened.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "random_map.hpp"
#include "slow_sight.hpp"
#include "waybreaker/advanced/search.hpp"

namespace waybreaker {
namespace {

double length_of(const std::vector<Cell>& path) {
    double length = 0;
    for (std::size_t i = 1; i < path.size(); ++i) length += distance(path[i - 1], path[i]);
    return length;
}

RC_GTEST_PROP(Shortened, LeavesNothingToGainNearABend, ()) {
    const PlainMap plain = *random_map(16, 16);
    const Map map(plain.grid());
    const Body body{.radius = *rc::gen::element(0.2, 0.5, 0.5, 0.7, 1.2)};
    SearchOptions by_steps;
    by_steps.planner = Algorithm::astar;
    by_steps.body = body;
    Searcher searcher;
    const OpenedMap opened(map);
    const SearchResult found = searcher.find(opened, any_free_cell(plain), any_free_cell(plain), by_steps);
    RC_PRE(found.status == SearchStatus::found);
    std::vector<Cell> path;
    for (const Point p : shortened(opened, body, {found.path.begin(), found.path.end()})) path.push_back(cell_of(p));

    RC_ASSERT(path.front() == found.path.front() && path.back() == found.path.back());
    RC_ASSERT(length_of(path) <= found.length * (1 + 1e-9));
    for (std::size_t i = 1; i < path.size(); ++i) RC_ASSERT(slow::sees(plain, path[i - 1], path[i], body));
    RC_CLASSIFY(path.size() > 2, "with bends");
    for (std::size_t i = 1; i + 1 < path.size(); ++i) {
        RC_ASSERT(!slow::sees(plain, path[i - 1], path[i + 1], body));
        const double length = distance(path[i - 1], path[i]) + distance(path[i], path[i + 1]);
        for (const Cell c : plain.free_cells()) {
            if (std::max(std::abs(c.x - path[i].x), std::abs(c.y - path[i].y)) > 3) continue;
            if (distance(path[i - 1], c) + distance(c, path[i + 1]) >= length - 1e-6) continue;
            RC_ASSERT(!slow::sees(plain, c, c, body) || !slow::sees(plain, path[i - 1], c, body) ||
                      !slow::sees(plain, c, path[i + 1], body));
        }
    }
}

}  // namespace
}  // namespace waybreaker
