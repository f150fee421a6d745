// The bound by steps against the oracle's shortest path, and against steps alone where nothing is crossed.
#include "crossing/step_bound.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "ascii_map.hpp"
#include "crossing_case.hpp"

namespace waybreaker {
namespace {

// Walls of # stay.
StepBound bound(std::string_view picture, int crossings) {
    const Map map = map_from_ascii(picture);
    std::vector<ObstacleId> walls;
    if (picture.find('#') != std::string_view::npos) walls.push_back(map.obstacle_at(mark_in_ascii(picture, '#')));
    return least_by_steps(map, mark_in_ascii(picture, 'S'), mark_in_ascii(picture, 'G'),
                          {.crossings = crossings, .protect = walls});
}

// The shortest path by legal steps to one of eight neighbours: relaxed until nothing changes.
double shortest_by_steps(const PlainMap& map, Cell start, Cell goal) {
    const auto free = [&](Cell c) { return map.contains(c) && !map.blocked(c); };
    std::vector<double> lengths(map.obstacles.size(), std::numeric_limits<double>::infinity());
    if (free(start)) lengths[map.index(start)] = 0;
    for (bool changed = true; changed;) {
        changed = false;
        for (const Cell from : map.cells()) {
            for (int dy = -1; dy <= 1; ++dy) {
                for (int dx = -1; dx <= 1; ++dx) {
                    const Cell to{from.x + dx, from.y + dy};
                    if (!free(to) || !free({from.x + dx, from.y}) || !free({from.x, from.y + dy})) continue;
                    const double length = lengths[map.index(from)] + std::hypot(dx, dy);
                    if (length >= lengths[map.index(to)]) continue;
                    lengths[map.index(to)] = length;
                    changed = true;
                }
            }
        }
    }
    return lengths[map.index(goal)];
}

RC_GTEST_PROP(StepBound, IsALimitForTheSquare, ()) {
    CrossingCase problem = *rc::gen::oneOf(any_case(10), any_walls());
    problem.set(movers.front());
    problem.done_after.clear();
    problem.prices.clear();
    double least = slow::CrossingOracle::nowhere;
    const slow::CrossingOracle oracle = problem.oracle();
    for (const slow::Set set : problem.choices()) {
        least = std::min(least, oracle.shortest(set | slow::set_of(problem.removed)));
    }
    const StepBound found = least_by_steps(problem.map, problem.start, problem.goal, problem.options());
    RC_LOG() << problem << "steps " << found.least << ", least " << least << '\n';
    RC_ASSERT(found.least <= least * (1 + 1e-9));
    RC_ASSERT(found.crossed.size() <= std::size_t(problem.crossings));
    if (problem.crossings == 0) {
        const double steps = shortest_by_steps(plain(problem.map, problem.removed), problem.start, problem.goal);
        RC_ASSERT(std::isfinite(found.least) == std::isfinite(steps));
        const double least_by_strides = steps * std::sqrt(5.0) / (1 + std::sqrt(2.0));
        RC_ASSERT(found.least >= least_by_strides / 1.0276 - 1.0 / 16);
    }
    // What is dearer than the limit does not matter.
    CrossingOptions limited = problem.options();
    limited.length_limit = 5;
    const StepBound within = least_by_steps(problem.map, problem.start, problem.goal, limited);
    RC_ASSERT(within.least <= std::min(5.0, least * (1 + 1e-9)));
    RC_ASSERT(within.least >= std::min(5.0, found.least) * (1 - 1e-9));
}

TEST(StepBound, IsNearTheLengthOfWindingPaths) {
    const std::string_view winding = R"(
        S.......................
        #######################.
        ........................
        .#######################
        ........................
        #######################.
        G.......................)";
    const StepBound found = bound(winding, 0);
    EXPECT_GT(found.least, 4 * 22 / 1.0275);
    EXPECT_FALSE(found.limited);
}

TEST(StepBound, TellsWhatTheShortestWayCrosses) {
    const std::string_view picture = R"(
        ..........#..........
        ..........#..........
        ..........#..........
        S.........a.........G
        ..........#..........
        ..........#..........
        ..........#..........)";
    EXPECT_EQ(bound(picture, 1).crossed,
              std::vector<ObstacleId>{map_from_ascii(picture).obstacle_at(mark_in_ascii(picture, 'a'))});
    EXPECT_DOUBLE_EQ(bound(picture, 1).least, 20);
    EXPECT_EQ(bound(picture, 0).least, std::numeric_limits<double>::infinity());
}

// Who has crossed one part of an obstacle crosses the others for nothing; and two that lie in each other.
TEST(StepBound, CountsAnObstacleOnce) {
    const std::string_view fork = R"(
        #########
        S.a.a.a.G
        #########)";
    EXPECT_DOUBLE_EQ(bound(fork, 1).least, 8);
    const std::string_view nested = R"(
        #########
        Sababab.G
        #########)";
    EXPECT_EQ(bound(nested, 1).least, std::numeric_limits<double>::infinity());
    EXPECT_DOUBLE_EQ(bound(nested, 2).least, 8);
}

// Costs are integers of 32 bits.
TEST(StepBound, HoldsForPathsOfAnyLength) {
    constexpr int side = 601;
    Grid grid(side, side);
    for (int y = 1; y < side; y += 2) {
        for (int x = 0; x < side; ++x) grid.set_blocked({x, y}, x != (y % 4 == 1 ? side - 1 : 0));
    }
    const Map map(std::move(grid));
    const Cell start{0, 0};
    const Cell goal{side - 1, side - 1};
    const double shortest = CrossingSearcher().find(map, start, goal).best.length;
    EXPECT_GT(shortest, 180'000);
    EXPECT_LE(least_by_steps(map, start, goal, {}).least, shortest);
}

TEST(StepBound, IsTheLimitWhereNoPathIsSoShort) {
    const Map map = map_from_ascii("S................G");
    EXPECT_DOUBLE_EQ(least_by_steps(map, {0, 0}, {17, 0}, {.length_limit = 3}).least, 3);
}

TEST(StepBound, HoldsWhereItIsStopped) {
    const Map map = map_from_ascii("S................G");
    for (const std::uint64_t expansions : {0U, 1U, 5U}) {
        const StepBound found = least_by_steps(map, {0, 0}, {17, 0}, {.limits = {.expansions = expansions}});
        EXPECT_TRUE(found.limited);
        EXPECT_DOUBLE_EQ(found.least, 17);
    }
    EXPECT_TRUE(least_by_steps(map, {0, 0}, {17, 0}, {.limits = {.seconds = 0}}).limited);
}

}  // namespace
}  // namespace waybreaker
