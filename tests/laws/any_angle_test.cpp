// Laws of Theta* and Lazy Theta*: legal paths, never shorter than the shortest any-angle path between cell centres.
//
// Neither is optimal. That Theta* is no longer than A* on the grid is no law (an early parent can hide a better one),
// only nearly always so: over fixed maps that is counted, and bounded, below.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <iostream>
#include <limits>
#include <random>

#include "legal_path.hpp"
#include "random_map.hpp"

namespace waybreaker {
namespace {

// Dijkstra over all pairs of free cells in sight of each other.
double shortest_any_angle(const PlainMap& map, Cell start, Cell goal, const Body& body) {
    std::vector<Cell> rest = map.free_cells();
    std::vector<double> length(map.obstacles.size(), std::numeric_limits<double>::infinity());
    length[map.index(start)] = 0;
    while (!rest.empty()) {
        const auto nearest = std::min_element(
            rest.begin(), rest.end(), [&](Cell a, Cell b) { return length[map.index(a)] < length[map.index(b)]; });
        const Cell cell = *nearest;
        rest.erase(nearest);
        const double here = length[map.index(cell)];
        if (cell == goal || here == std::numeric_limits<double>::infinity()) break;
        for (const Cell to : rest) {
            double& known = length[map.index(to)];
            if (here + distance(cell, to) < known && slow::sees(map, cell, to, body)) known = here + distance(cell, to);
        }
    }
    return length[map.index(goal)];
}

RC_GTEST_PROP(AnyAngle, PathsAreLegalAndNoShorterThanTheShortest, ()) {
    const PlainMap plain = *random_map(13, 11);
    const Map map(plain.grid());
    const Cell start = any_free_cell(plain);
    const Cell goal = any_free_cell(plain);
    const Body body{.corners = any_corners()};
    const double shortest = shortest_any_angle(plain, start, goal, body);
    for (const Algorithm planner : {Algorithm::theta, Algorithm::lazy_theta}) {
        for (const double weight : {1.0, 1.5}) {
            const SearchOptions options{.planner = planner, .weight = weight, .body = body};
            const SearchResult result = Searcher().find(OpenedMap(map), start, goal, options);
            const std::string fault = path_fault(plain, start, goal, options, result);
            if (!fault.empty()) RC_LOG() << fault << '\n';
            RC_ASSERT(fault.empty());
            RC_ASSERT((result.status == SearchStatus::found) == (shortest < 1e9));
            if (result.status == SearchStatus::found) RC_ASSERT(result.length >= shortest - 1e-9);
        }
    }
}

RC_GTEST_PROP(AnyAngle, PathsOfWideAgentsAreLegal, ()) {
    const PlainMap plain = *random_map(30, 24);
    const Map map(plain.grid());
    const Cell start = any_free_cell(plain);
    const Cell goal = any_free_cell(plain);
    for (const Algorithm planner : {Algorithm::theta, Algorithm::lazy_theta}) {
        const SearchOptions options{.planner = planner, .body = {.radius = *rc::gen::element(0.501, 1.0, 1.7)}};
        const SearchResult result = Searcher().find(OpenedMap(map), start, goal, options);
        RC_ASSERT(path_fault(plain, start, goal, options, result).empty());
    }
}

TEST(AnyAngle, IsStraightWhereNothingIsInTheWay) {
    const Map map(Grid(40, 30));
    for (const Algorithm planner : {Algorithm::theta, Algorithm::lazy_theta}) {
        const SearchResult result = Searcher().find(OpenedMap(map), {3, 4}, {38, 27}, {.planner = planner});
        EXPECT_EQ(result.path, (std::vector<Cell>{{3, 4}, {38, 27}}));
    }
}

// Fixed random maps: the shares are the same in every run.
TEST(AnyAngle, IsHardlyEverLongerThanAStar) {
    std::mt19937 random(20180702);
    const auto below = [&random](int n) { return int(random() % unsigned(n)); };
    Searcher searcher;
    int found = 0;
    int longer = 0;
    int lazy_longer = 0;
    double worst = 1;
    double worst_lazy = 1;
    double theta_sum = 0;
    double lazy_sum = 0;
    double astar_sum = 0;
    for (int round = 0; round < 2000; ++round) {
        const int width = 8 + below(50);
        const int height = 8 + below(50);
        Grid grid(width, height);
        const int percent = 5 + below(35);
        for (Cell c; c.y < grid.height(); ++c.y) {
            for (c.x = 0; c.x < grid.width(); ++c.x) grid.set_blocked(c, below(100) < percent);
        }
        const Map map(std::move(grid));
        const Cell start{below(map.width()), below(map.height())};
        const Cell goal{below(map.width()), below(map.height())};
        const auto length = [&](Algorithm planner) {
            return searcher.find(OpenedMap(map), start, goal, {.planner = planner}).length;
        };
        const double astar = length(Algorithm::astar);
        if (astar == 0) continue;
        const double theta = length(Algorithm::theta);
        const double lazy = length(Algorithm::lazy_theta);
        ++found;
        longer += theta > astar + 1e-9 ? 1 : 0;
        lazy_longer += lazy > astar + 1e-9 ? 1 : 0;
        worst = std::max(worst, theta / astar);
        worst_lazy = std::max(worst_lazy, lazy / astar);
        theta_sum += theta;
        lazy_sum += lazy;
        astar_sum += astar;
    }
    std::cout << found << " paths; Theta*: " << longer << " longer than A*, worst " << worst << ", mean "
              << theta_sum / astar_sum << "; Lazy Theta*: " << lazy_longer << ", worst " << worst_lazy << ", mean "
              << lazy_sum / astar_sum << '\n';
    EXPECT_GT(found, 800);
    EXPECT_LE(longer, found / 100);
    EXPECT_LE(worst, 1.01);
    EXPECT_LE(lazy_longer, found / 50);
    EXPECT_LE(worst_lazy, 1.03);
    EXPECT_LT(theta_sum, 0.98 * astar_sum);
    EXPECT_LT(lazy_sum, 1.005 * theta_sum);
}

}  // namespace
}  // namespace waybreaker
