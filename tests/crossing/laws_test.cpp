// Laws of crossing paths on maps too large for the oracle: more crossings never cost more, every square's path is a
// point's, and neither mirrors nor larger cells change a length.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "ascii_map.hpp"
#include "crossing_case.hpp"

namespace waybreaker {
namespace {

// Labels of a map seen another way: the cell shown at c is the one at `where(c)`.
template <class Where>
Map seen(const Map& map, int width, int height, Where where) {
    std::vector<std::uint32_t> labels;
    for (Cell c; c.y < height; ++c.y) {
        for (c.x = 0; c.x < width; ++c.x) labels.push_back(map.obstacle_at(where(c)).value);
    }
    std::vector<ObstacleAttributes> attributes(map.obstacles().size() + 1);
    for (const Obstacle& obstacle : map.obstacles()) attributes[obstacle.id.value].destructible = obstacle.destructible;
    return Map::from_labels(width, height, labels, attributes);
}

double cost(const Map& map, Cell start, Cell goal, const CrossingOptions& options,
            const crossing::Opener& opener = {}) {
    CrossingSearcher searcher;
    return crossing::Access::find(searcher, map, start, goal, options, opener).lower_bound;
}

CrossingCase plain_case(int most_side) {
    CrossingCase problem = *any_case(most_side);
    problem.removed.clear();
    problem.protect.clear();
    problem.budget = std::numeric_limits<double>::infinity();
    problem.done_after.clear();
    problem.prices.clear();
    return problem;
}

RC_GTEST_PROP(CrossingLaws, MoreCrossingsNeverCostMore, ()) {
    CrossingCase problem = *any_case(40);
    double before = std::numeric_limits<double>::infinity();
    for (problem.crossings = 0; problem.crossings <= 4; ++problem.crossings) {
        const double now = cost(problem.map, problem.start, problem.goal, problem.options(), problem.opener());
        RC_LOG() << problem << now << '\n';
        RC_ASSERT(now <= before * (1 + 1e-12));
        before = now;
    }
}

RC_GTEST_PROP(CrossingLaws, AWeightedPathIsAsLongAsItsWeightAllows, ()) {
    CrossingCase problem = *any_case(40);
    problem.done_after.clear();
    const CrossingResult best = problem.find();
    CrossingOptions options = problem.options();
    options.weight = *rc::gen::element(1.0, 1.01, 1.15, 2.0, 5.0);
    const CrossingResult found = problem.find(options);
    RC_LOG() << problem << best.best.cost << ' ' << found.best.cost << " proven " << found.lower_bound << '\n';
    RC_ASSERT(found.status == best.status);
    RC_ASSERT(found.lower_bound <= best.lower_bound * (1 + 1e-12));
    options.limits.expansions = *rc::gen::inRange<std::uint64_t>(1, 50);
    const CrossingResult stopped = problem.find(options);
    RC_ASSERT(stopped.lower_bound <= best.lower_bound * (1 + 1e-12));
    if (best.status != SearchStatus::found) return;
    RC_ASSERT(found.best.cost >= best.best.cost * (1 - 1e-12));
    RC_ASSERT(found.best.cost <= best.best.cost * options.weight * (1 + 1e-12));
    RC_ASSERT(found.lower_bound >= found.best.cost / options.weight * (1 - 1e-12));
    RC_ASSERT(found.best.crossed.size() <= std::size_t(problem.crossings));
}

// Of one search. A choice of several, each with a budget of its own, has no such law.
RC_GTEST_PROP(CrossingLaws, ASearchThatMayExpandMoreProvesNoLess, ()) {
    const CrossingCase problem = *any_case(24);
    CrossingOptions options = problem.options();
    double before = 0;
    for (options.limits.expansions = 1; options.limits.expansions < 100;
         options.limits.expansions += std::uint64_t(*number(1, 9))) {
        const double proven = problem.find(options).lower_bound;
        RC_ASSERT(proven >= before * (1 - 1e-12));
        before = proven;
    }
}

// What was crossed and left then counts by its number and prices, and not by its members. Of a point in time costs are
// lower limits: they may differ, but not be above the square's.
RC_GTEST_PROP(CrossingLaws, ObstaclesThatEachOpenAloneAreSearchedByTheirNumber, ()) {
    CrossingCase problem = *number(0, 1) == 0 ? *any_walls() : *any_case(24);
    const std::vector<double> opened = *some_times(problem.map);
    problem.done_after.clear();
    const auto find = [&](const Mover& mover, bool each_alone) {
        problem.set(mover);
        CrossingOptions options = problem.options();
        options.opened_after = [&](std::span<const ObstacleId> crossed) {
            double last = 0;
            for (const ObstacleId id : crossed) last = std::max(last, opened[id.value]);
            return last;
        };
        CrossingSearcher searcher;
        return crossing::Access::find(searcher, problem.map, problem.start, problem.goal, options,
                                      {.opens_each_alone = each_alone});
    };
    const CrossingResult square = find({Body{}}, false);
    RC_LOG() << problem << square.best.cost << '\n';
    const CrossingResult by_number = find({Body{}}, true);
    RC_ASSERT(by_number.status == square.status);
    if (square.status != SearchStatus::found) return;
    RC_ASSERT(std::abs(by_number.best.cost - square.best.cost) <= 1e-9 * (1 + square.best.cost));
    for (const Mover& mover : {Mover{point_body}, Mover{Body{}, true}}) {
        const CrossingResult limit = find(mover, true);
        RC_ASSERT(limit.status == SearchStatus::found);
        RC_ASSERT(limit.best.cost <= square.best.cost * (1 + 1e-12));
    }
}

// The point goes between b and c along their edge. Which of them it crosses matters, as b opens late.
TEST(CrossingLaws, WhatWasCrossedMattersWhereItOpensLate) {
    const Map map = map_from_ascii(R"(
        .a.a.b...
        .a.a.c.d.)");
    CrossingOptions options;
    options.crossings = 2;
    options.opened_after = [](std::span<const ObstacleId> crossed) {
        return std::ranges::find(crossed, ObstacleId{2}) == crossed.end() ? 0 : 7;
    };
    const crossing::Opener each_alone{.opens_each_alone = true};
    const double square = cost(map, {0, 0}, {8, 1}, options, each_alone);
    options.body = point_body;
    EXPECT_LE(cost(map, {0, 0}, {8, 1}, options, each_alone), square);
}

// Then obstacles open one after the other.
RC_GTEST_PROP(CrossingLaws, TheBestInTimeIsTheFirstThatIsToldOf, ()) {
    CrossingCase problem = *number(0, 3) > 0 ? *any_walls() : *any_case(16);
    problem.set(movers.front());
    problem.crossings = std::max(problem.crossings, *number(0, 3));
    const std::vector<double> takes = *some_times(problem.map);
    problem.done_after.clear();
    CrossingOptions options = problem.options();
    options.opened_after = [&](std::span<const ObstacleId> crossed) {
        double sum = 0;
        for (const ObstacleId id : crossed) sum += takes[id.value] / 2;
        return sum;
    };
    const CrossingResult best = problem.find(options);
    std::optional<double> first;
    problem.enumerate(options, [&](const CrossingPath& path) {
        first = path.cost;
        return false;
    });
    RC_LOG() << problem << best.best.cost << ' ' << first.value_or(-1) << '\n';
    RC_ASSERT(first.has_value() == (best.status == SearchStatus::found));
    if (first) RC_ASSERT(std::abs(best.best.cost - *first) <= 1e-9 * (1 + *first));
}

RC_GTEST_PROP(CrossingLaws, ASquareIsNeverFasterThanAPoint, ()) {
    CrossingCase problem = *any_case(40);
    const auto cost_of = [&](const Mover& mover) {
        problem.set(mover);
        return cost(problem.map, problem.start, problem.goal, problem.options(), problem.opener());
    };
    const double square = cost_of({Body{}});
    const double relaxed = cost_of({Body{}, true});
    const double point = cost_of({point_body});
    RC_LOG() << problem << square << ' ' << relaxed << ' ' << point << '\n';
    RC_ASSERT(relaxed <= square * (1 + 1e-12));
    RC_ASSERT(point <= relaxed * (1 + 1e-12));
}

RC_GTEST_PROP(CrossingLaws, TheWayBackIsAsLong, ()) {
    const CrossingCase problem = *any_case(40);
    RC_LOG() << problem;
    RC_ASSERT(same_length(cost(problem.map, problem.start, problem.goal, problem.options(), problem.opener()),
                          cost(problem.map, problem.goal, problem.start, problem.options(), problem.opener())));
}

RC_GTEST_PROP(CrossingLaws, MirrorsChangeNoLength, ()) {
    const CrossingCase problem = plain_case(40);
    const int w = problem.map.width();
    const int h = problem.map.height();
    const double there = cost(problem.map, problem.start, problem.goal, problem.options());
    const auto mirrored = [&](Cell c) { return Cell{w - 1 - c.x, c.y}; };
    const auto turned = [](Cell c) { return Cell{c.y, c.x}; };
    RC_LOG() << problem << there << '\n';
    RC_ASSERT(same_length(there, cost(seen(problem.map, w, h, mirrored), mirrored(problem.start),
                                      mirrored(problem.goal), problem.options())));
    RC_ASSERT(same_length(
        there, cost(seen(problem.map, h, w, turned), turned(problem.start), turned(problem.goal), problem.options())));
}

RC_GTEST_PROP(CrossingLaws, APointsPathGrowsWithTheMap, ()) {
    CrossingCase problem = plain_case(14);
    problem.set({point_body});
    const double there = cost(problem.map, problem.start, problem.goal, problem.options());
    const auto large = [](Cell c) { return Cell{3 * c.x + 1, 3 * c.y + 1}; };
    const Map map = seen(problem.map, 3 * problem.map.width(), 3 * problem.map.height(), [](Cell c) {
        return Cell{c.x / 3, c.y / 3};
    });
    RC_LOG() << problem << there << '\n';
    RC_ASSERT(same_length(3 * there, cost(map, large(problem.start), large(problem.goal), problem.options())));
}

// What is crossed may as well be removed before.
RC_GTEST_PROP(CrossingLaws, RemovingWhatIsCrossedLeavesTheSamePath, ()) {
    const CrossingCase problem = *any_case(40);
    const CrossingResult first = problem.find();
    if (first.status != SearchStatus::found) return;
    std::vector<ObstacleId> removed = problem.removed;
    removed.insert(removed.end(), first.best.crossed.begin(), first.best.crossed.end());
    const CrossingResult second =
        CrossingSearcher().find(problem.map, problem.start, problem.goal,
                                {.body = problem.body, .relaxed = problem.relaxed, .removed = removed});
    RC_LOG() << problem;
    RC_ASSERT(same_length(first.best.length, second.best.length) || first.best.cost > first.best.length);
    RC_ASSERT(second.best.crossed.empty());
}

}  // namespace
}  // namespace waybreaker
