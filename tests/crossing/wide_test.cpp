// Discs of other radii than 0.5: the search on the grown map against the oracle, and both against the disc itself.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "ascii_map.hpp"
#include "crossing/step_bound.hpp"
#include "crossing_case.hpp"

namespace waybreaker {
namespace {

double any_radius() {
    return *rc::gen::element(0.001, 0.2, 0.36, 0.5, 0.501, 0.6, 0.707, 0.75, 1.0, 1.118, 1.5, 2.0, 2.25);
}

// Few cells are blocked, so that a wide disc has some room.
Map random_sparse_map(int most_side) {
    const int width = *number(4, most_side);
    const int height = *number(4, most_side);
    std::vector<std::uint32_t> labels(std::size_t(width * height));
    const int shapes = *number(1, 5);
    for (int i = 0; i < shapes; ++i) {
        const Cell min{*number(0, width - 1), *number(0, height - 1)};
        const Cell max{std::min(min.x + *number(0, 2), width - 1), std::min(min.y + *number(0, 6), height - 1)};
        for (Cell c = min; c.y <= max.y; ++c.y) {
            for (c.x = min.x; c.x <= max.x; ++c.x) labels[std::size_t(c.y * width + c.x)] = std::uint32_t(i + 1);
        }
    }
    std::vector<ObstacleAttributes> attributes(6);
    for (ObstacleAttributes& label : attributes) label.destructible = *number(0, 5) > 0;
    return Map::from_labels(width, height, labels, attributes);
}

CrossingCase random_wide_case(int most_side) {
    CrossingCase problem = random_case(random_sparse_map(most_side));
    problem.body = {.radius = any_radius()};
    // Where the agent has room, mostly.
    const PlainMap opened = plain(problem.map, problem.removed);
    const auto place = [&] {
        for (int tries = 0; tries < 8; ++tries) {
            const Cell c = any_cell(opened);
            if (slow::needed(opened, problem.body, false, c) == 0) return c;
        }
        return any_cell(opened);
    };
    problem.start = place();
    problem.goal = place();
    return problem;
}

double least(const CrossingCase& problem) {
    const slow::CrossingOracle oracle = problem.oracle();
    double best = slow::CrossingOracle::nowhere;
    for (const slow::Set set : problem.choices()) {
        best = std::min(best, problem.cost(oracle.shortest(set | slow::set_of(problem.removed)), set));
    }
    return best;
}

// The shortest path of the disc itself that bends at cell centres, when those obstacles are gone.
double shortest_of_disc(const CrossingCase& problem, slow::Set gone) {
    PlainMap map = plain(problem.map);
    for (std::uint32_t& obstacle : map.obstacles) obstacle = gone >> obstacle & 1 ? 0 : obstacle;
    std::vector<Cell> places{problem.start, problem.goal};
    for (const Cell c : map.cells()) {
        if (slow::sees(map, c, c, problem.body)) places.push_back(c);
    }
    for (const Cell end : {problem.start, problem.goal}) {
        if (!slow::sees(map, end, end, problem.body)) return slow::CrossingOracle::nowhere;
    }
    std::vector<double> lengths(places.size(), slow::CrossingOracle::nowhere);
    std::vector<bool> done(places.size());
    lengths[0] = 0;
    while (true) {
        std::size_t next = 1;
        for (std::size_t i = 0; i < places.size(); ++i) {
            if (!done[i] && lengths[i] < lengths[next]) next = i;
        }
        if (next == 1) return lengths[1];
        done[next] = true;
        for (std::size_t i = 0; i < places.size(); ++i) {
            const double through = lengths[next] + distance(places[next], places[i]);
            if (!done[i] && through < lengths[i] && slow::sees(map, places[next], places[i], problem.body)) {
                lengths[i] = through;
            }
        }
    }
}

RC_GTEST_PROP(WideCrossing, IsTheShortestOnTheGrownMap, ()) {
    CrossingSearcher searcher;  // keeps grown maps from case to case
    CrossingCase problem = random_wide_case(10);
    for (const bool relaxed : {true, false, true}) {
        problem.relaxed = relaxed;
        const CrossingResult result = problem.find(searcher);
        const double expected = least(problem);
        RC_LOG() << problem << "found " << result.best.cost << ", least " << expected << '\n';
        RC_ASSERT((result.status == SearchStatus::found) == (expected < slow::CrossingOracle::nowhere));
        RC_ASSERT(same_length(expected, result.lower_bound));
        if (result.status != SearchStatus::found) continue;
        RC_ASSERT(path_fault(problem, problem.oracle(), result.best) == "");
        RC_ASSERT(same_length(expected, result.best.cost));
    }
}

RC_GTEST_PROP(WideCrossing, IsLegalForTheDiscAndTheRelaxedIsALimit, ()) {
    CrossingCase problem = random_wide_case(9);
    problem.done_after.clear();
    problem.prices.clear();
    problem.relaxed = false;
    CrossingSearcher searcher;
    const CrossingResult found = problem.find(searcher);
    double disc = slow::CrossingOracle::nowhere;
    for (const slow::Set set : problem.choices()) {
        disc = std::min(disc, shortest_of_disc(problem, set | slow::set_of(problem.removed)));
    }
    problem.relaxed = true;
    const double limit = problem.find(searcher).lower_bound;
    RC_LOG() << problem << "found " << found.best.length << ", disc " << disc << ", limit " << limit << '\n';
    RC_ASSERT(limit <= disc * (1 + 1e-9));
    if (problem.body.radius >= 0.36 && problem.body.radius <= 0.5) {
        const StepBound steps = least_by_steps(problem.map, problem.start, problem.goal, problem.options());
        RC_LOG() << "by steps " << steps.least << '\n';
        RC_ASSERT(steps.least <= disc * (1 + 1e-9));
    }
    if (problem.body.radius <= 0.5) RC_ASSERT((found.status == SearchStatus::found) == std::isfinite(disc));
    if (found.status != SearchStatus::found) return;
    RC_ASSERT(found.best.length >= disc * (1 - 1e-9));
    if (problem.body.radius >= 0.36 && problem.body.radius <= 0.5) RC_ASSERT(found.best.length <= 1.0824 * disc);
    std::vector<ObstacleId> gone = problem.removed;
    gone.insert(gone.end(), found.best.crossed.begin(), found.best.crossed.end());
    const PlainMap opened = plain(problem.map, gone);
    for (std::size_t i = 1; i < found.best.path.size(); ++i) {
        const auto cell = [](Point p) { return Cell{int(std::lround(p.x)), int(std::lround(p.y))}; };
        RC_ASSERT(slow::sees(opened, cell(found.best.path[i - 1]), cell(found.best.path[i]), problem.body));
    }
}

// Where every growth overlaps hundreds of others, it says so instead of filling the memory.
TEST(WideCrossing, GivesUpWhereTooManyObstaclesOverlap) {
    constexpr int side = 200;
    Grid grid(side, side);
    for (Cell c{60, 0}; c.y < side; ++c.y) {
        for (c.x = 60; c.x < side; ++c.x) grid.set_blocked(c, (c.x + c.y) % 2 == 0);
    }
    const Map map(std::move(grid));
    CrossingSearcher searcher;
    const CrossingOptions options{.body = {.radius = 20}, .crossings = 1};
    const CrossingResult result = searcher.find(map, {25, 25}, {25, 150}, options);
    EXPECT_EQ(result.status, SearchStatus::not_found);
    EXPECT_EQ(result.lower_bound, 125);
    EXPECT_TRUE(result.best.path.empty());
    EXPECT_EQ(
        CrossingSearcher().find(map, {25, 25}, {25, 150}, {.body = {.radius = 20}, .limits = {.seconds = 0}}).status,
        SearchStatus::limit_reached);
}

// Both obstacles stand in the way of a disc between them, but of a slim one neither.
TEST(WideCrossing, CrossesAllObstaclesThatAreTooNear) {
    const Map map = map_from_ascii(R"(
        ...aaa...
        ...aaa...
        .........
        ...bbb...
        ...bbb...)");
    CrossingSearcher searcher;
    const auto crossed = [&](double radius, int crossings) {
        return searcher.find(map, {1, 2}, {7, 2}, {.body = {.radius = radius}, .crossings = crossings}).best.crossed;
    };
    EXPECT_EQ(crossed(0.5, 2), std::vector<ObstacleId>{});
    EXPECT_EQ(crossed(0.6, 2), (std::vector<ObstacleId>{{1}, {2}}));
    EXPECT_EQ(crossed(1.5, 2), (std::vector<ObstacleId>{{1}, {2}}));
    EXPECT_EQ(searcher.find(map, {1, 2}, {7, 2}, {.body = {.radius = 0.6}, .crossings = 1}).status,
              SearchStatus::found);  // through one of them, along the other
    EXPECT_EQ(searcher.find(map, {1, 2}, {7, 2}, {.body = {.radius = 2.5}, .crossings = 1}).status,
              SearchStatus::no_path);
}

}  // namespace
}  // namespace waybreaker
