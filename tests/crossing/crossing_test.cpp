// CrossingSearcher::find against the oracle: the same length, a path that is what it claims to be, a true bound.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "ascii_map.hpp"
#include "crossing_case.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker {
namespace {

// Knows the answers to all problems that differ in their limits alone.
class Judge {
  public:
    explicit Judge(const CrossingCase& problem) : oracle_(problem.oracle()) {}

    double least(const CrossingCase& problem) {
        double best = slow::CrossingOracle::nowhere;
        for (const slow::Set set : problem.choices()) {
            best = std::min(best, problem.cost(length(set | slow::set_of(problem.removed)), set));
        }
        return best;
    }

    std::string path_fault(const CrossingCase& problem, const CrossingPath& path) const {
        return waybreaker::path_fault(problem, oracle_, path);
    }

    void check(const CrossingCase& problem, const CrossingResult& result) {
        const double expected = least(problem);
        RC_LOG() << problem << "found " << result.best.cost << ", least " << expected << ", bound "
                 << result.lower_bound << '\n';
        RC_ASSERT((result.status == SearchStatus::found) == (expected < slow::CrossingOracle::nowhere));
        RC_ASSERT(same_length(expected, result.lower_bound));
        if (result.status != SearchStatus::found) {
            RC_ASSERT(result.status == SearchStatus::no_path);
            RC_ASSERT(result.best.path.empty());
            return;
        }
        RC_ASSERT(path_fault(problem, result.best) == "");
        RC_ASSERT(same_length(expected, result.best.cost));
    }

  private:
    double length(slow::Set gone) {
        const auto [known, fresh] = lengths_.try_emplace(gone);
        if (fresh) known->second = oracle_.shortest(gone);
        return known->second;
    }

    slow::CrossingOracle oracle_;
    std::map<slow::Set, double> lengths_;
};

RC_GTEST_PROP(Crossing, IsTheShortest, ()) {
    CrossingSearcher searcher;  // keeps its memory from case to case
    const Map map = *number(0, 1) == 0 ? random_connected_map(9) : random_label_map(9);
    for (int mission = 0; mission < 4; ++mission) {
        CrossingCase problem = random_case(map);
        for (const Mover& mover : movers) {
            problem.set(mover);
            Judge(problem).check(problem, problem.find(searcher));
        }
    }
}

// Most obstacles leave a convex piece of free ground.
RC_GTEST_PROP(Crossing, IsTheShortestThroughSections, ()) {
    CrossingSearcher searcher;
    const CrossingCase problem = random_case(random_sections(9));
    Judge(problem).check(problem, problem.find(searcher));
}

// What was crossed once may be in the way again, so that a label's set decides how it can go on.
RC_GTEST_PROP(Crossing, IsTheShortestThroughWalls, ()) {
    CrossingSearcher searcher;
    CrossingCase problem = *any_walls();
    Judge judge(problem);
    for (int limits = 0; limits < 24; ++limits) {
        problem.crossings = *number(0, 4);
        if (limits >= 8) problem.budget = random_budget(problem.map);
        if (limits >= 16) problem.done_after = *some_times(problem.map);
        judge.check(problem, problem.find(searcher));
    }
}

RC_GTEST_PROP(Crossing, GivesTheSameAgain, ()) {
    const CrossingCase problem = *any_case(12);
    const CrossingCase other = *any_case(12);
    CrossingSearcher searcher;
    const auto find = [&](const CrossingCase& c) { return c.find(searcher); };
    const CrossingResult first = find(problem);
    find(other);
    const CrossingResult again = find(problem);
    RC_ASSERT(first.best.path == again.best.path);
    RC_ASSERT(first.best.crossed == again.best.crossed);
    RC_ASSERT(first.best.length == again.best.length);
    RC_ASSERT(first.lower_bound == again.lower_bound);
    RC_ASSERT(first.expanded == again.expanded);
    RC_ASSERT(first.generated == again.generated);
}

RC_GTEST_PROP(Crossing, HoldsWhatItProvedWhenStopped, ()) {
    const CrossingCase problem = *any_case(9);
    Judge judge(problem);
    const double expected = judge.least(problem);
    CrossingOptions options = problem.options();
    switch (*number(0, 3)) {
        case 0:
            options.limits.expansions = std::uint64_t(*number(0, 30));
            break;
        case 1:
            options.length_limit = *number(0, 20);
            break;
        case 2:
            options.limits.seconds = 0;
            break;
        default: {
            StopSource source;
            source.request_stop();
            options.limits.stop = source.get_token();
        }
    }
    const CrossingResult result = problem.find(options);
    RC_LOG() << problem << "limits: " << options.limits.expansions << " expansions, length " << options.length_limit
             << ", time " << options.limits.seconds << "; found " << result.best.cost << ", least " << expected
             << ", bound " << result.lower_bound << '\n';
    if (result.status == SearchStatus::found) {
        RC_ASSERT(judge.path_fault(problem, result.best) == "");
        RC_ASSERT(same_length(expected, result.best.cost));
        RC_ASSERT(result.best.cost <= options.length_limit);
    } else {
        if (!result.best.path.empty()) RC_ASSERT(judge.path_fault(problem, result.best) == "");
        RC_ASSERT(result.lower_bound <= expected * (1 + 1e-9));
        RC_ASSERT(options.length_limit == std::numeric_limits<double>::infinity() ||
                  expected > options.length_limit * (1 - 1e-9));
        if (options.length_limit < 1e9) RC_ASSERT(result.lower_bound >= options.length_limit);
    }
}

TEST(Crossing, HasNoPathFromOrToAPlaceThatIsClosed) {
    const Map map = map_from_ascii("aa.. .... ...b");
    CrossingSearcher searcher;
    for (const auto& [start, goal] : {std::pair{Cell{0, 0}, Cell{3, 0}},
                                      {Cell{0, 1}, Cell{3, 2}},
                                      {Cell{-1, 0}, Cell{1, 1}},
                                      {Cell{0, 1}, Cell{4, 1}}}) {
        const CrossingResult result = searcher.find(map, start, goal, {.crossings = 2});
        EXPECT_EQ(result.status, SearchStatus::no_path);
        EXPECT_EQ(result.lower_bound, std::numeric_limits<double>::infinity());
    }
    const std::vector<ObstacleId> removed{{1}};
    const CrossingResult result = searcher.find(map, {0, 0}, {3, 0}, {.removed = removed});
    EXPECT_EQ(result.status, SearchStatus::found);
    EXPECT_DOUBLE_EQ(result.best.length, 3);
}

// A ray that squeezes along an obstacle can meet it again in its way.
TEST(Crossing, NeverPassesAProtectedObstacle) {
    const std::string_view picture = R"(
        G..
        bba
        Saa
        .ca
        ...)";
    const Map map = map_from_ascii(picture);
    const std::vector<ObstacleId> protect{map.obstacle_at(mark_in_ascii(picture, 'a'))};
    const CrossingOptions options{.body = point_body, .crossings = 1, .protect = protect};
    CrossingSearcher().enumerate(map, {0, 2}, {0, 0}, options, [&](const CrossingPath& path) {
        EXPECT_EQ(std::ranges::count(path.crossed, protect[0]), 0);
        return true;
    });
}

RC_GTEST_PROP(Crossing, OfSomeObstaclesOnlyIsThatWithAllOthersProtected, ()) {
    CrossingCase problem = *any_case(8);
    std::vector<ObstacleId> only;
    std::vector<ObstacleId> others = problem.protect;
    for (const Obstacle& obstacle : problem.map.obstacles()) {
        (*number(0, 1) == 0 ? only : others).push_back(obstacle.id);
    }
    RC_PRE(!only.empty());
    CrossingOptions some = problem.options();
    some.only = only;
    CrossingOptions rest = problem.options();
    rest.protect = others;
    CrossingSearcher searcher;
    const CrossingResult a = problem.find(searcher, some);
    const CrossingResult b = problem.find(searcher, rest);
    RC_LOG() << problem;
    RC_ASSERT(a.status == b.status);
    RC_ASSERT(a.best.path == b.best.path);
    RC_ASSERT(a.best.crossed == b.best.crossed);
}

TEST(Crossing, ListsObstaclesInTheOrderOfThePath) {
    const std::string_view picture = R"(
        .cab.
        GcabS
        .cab.)";
    const Map map = map_from_ascii(picture);
    const auto id = [&](char letter) { return map.obstacle_at(mark_in_ascii(picture, letter)); };
    for (const Body body : {Body{}, point_body}) {
        const CrossingResult result = CrossingSearcher().find(map, {4, 1}, {0, 1}, {.body = body, .crossings = 3});
        EXPECT_EQ(result.best.crossed, (std::vector<ObstacleId>{id('b'), id('a'), id('c')}));
    }
}

// Whether the shortest path with one crossing goes through `a` twice, although it leaves the box around it in between,
// and `b` would be the shorter way there.
void expect_to_come_back(const Body& body, std::string_view picture) {
    const Map map = map_from_ascii(picture);
    CrossingCase problem{map, mark_in_ascii(picture, 'S'), mark_in_ascii(picture, 'G'), body, 1};
    const ObstacleId stone = map.obstacle_at(mark_in_ascii(picture, '#'));
    problem.protect = {stone};
    const CrossingResult result = CrossingSearcher().find(map, problem.start, problem.goal, problem.options());
    EXPECT_EQ(result.best.crossed, std::vector<ObstacleId>{map.obstacle_at(mark_in_ascii(picture, 'a'))});
    EXPECT_TRUE(same_length(result.best.length, Judge(problem).least(problem)));
}

TEST(Crossing, ComesBackThroughWhatItHasLeft) {
    expect_to_come_back(point_body, R"(
        .a....
        Sb....
        .#....
        ###...
        .#....
        .a....
        G#....)");
    expect_to_come_back(Body{}, R"(
        .a......
        Sb......
        .#......
        #####...
        .#......
        .a......
        G#......)");
}

// Before anything is expanded.
TEST(Crossing, KnowsHowFarItIsAroundWhatStays) {
    constexpr int width = 9;
    constexpr int height = 5;
    std::vector<std::uint32_t> labels(std::size_t(width * height));
    for (const Cell c : {Cell{4, 0}, Cell{4, 1}, Cell{4, 2}, Cell{4, 3}}) labels[std::size_t(c.y * width + c.x)] = 1;
    labels[2 * width + 2] = 2;
    std::vector<ObstacleAttributes> attributes(3);
    attributes[1].destructible = false;
    const Map map = Map::from_labels(width, height, labels, attributes);
    for (const Mover& mover : movers) {
        CrossingOptions options{.body = mover.body, .relaxed = mover.relaxed, .crossings = 1};
        CrossingSearcher searcher;
        const CrossingResult best = searcher.find(map, {0, 2}, {8, 2}, options);
        options.limits.expansions = 0;
        const CrossingResult stopped = searcher.find(map, {0, 2}, {8, 2}, options);
        EXPECT_EQ(stopped.status, SearchStatus::limit_reached);
        EXPECT_TRUE(same_length(stopped.lower_bound, best.best.length));
        EXPECT_GT(stopped.lower_bound, 8.2);
    }
}

TEST(Crossing, StaysWhereItIs) {
    const Map map = map_from_ascii("..a");
    const CrossingResult result = CrossingSearcher().find(map, {1, 0}, {1, 0}, {});
    EXPECT_EQ(result.status, SearchStatus::found);
    EXPECT_EQ(result.best.length, 0);
    EXPECT_EQ(result.lower_bound, 0);
}

TEST(Crossing, RefusesOptionsOutOfRange) {
    const Map map = map_from_ascii("..a");
    const Map wall = map_from_ascii("..a.. ..a.. ..a..");
    const auto find = [&](const CrossingOptions& options) { CrossingSearcher().find(map, {0, 0}, {1, 0}, options); };
    const std::vector<ObstacleId> unknown{{2}};
    const std::vector<ObstacleId> none{{0}};
    EXPECT_THROW(find({.crossings = -1}), InputError);
    EXPECT_THROW(find({.removed = unknown}), InputError);
    EXPECT_THROW(find({.removed = none}), InputError);
    EXPECT_THROW(find({.protect = unknown}), InputError);
    EXPECT_THROW(find({.body = {.radius = 33}}), InputError);
    EXPECT_THROW(find({.body = {.corners = Corners::cut}}), InputError);
    EXPECT_THROW(find({.budget = -1}), InputError);
    EXPECT_THROW(find({.length_limit = std::nan("")}), InputError);
    EXPECT_THROW(find({.expected = std::nan("")}), InputError);
    EXPECT_THROW(find({.weight = 0.5}), InputError);
    EXPECT_THROW(find({.weight = std::nan("")}), InputError);
    EXPECT_NO_THROW(find({.crossings = 1000}));
    const auto answer = [](double value) { return [value](std::span<const ObstacleId>) { return value; }; };
    const auto cross = [&](const CrossingOptions& options) { CrossingSearcher().find(wall, {0, 1}, {4, 1}, options); };
    EXPECT_THROW(cross({.crossings = 1, .opened_after = answer(std::nan(""))}), InputError);
    for (const double never : {std::nan(""), -1.0}) {
        CrossingSearcher searcher;
        const crossing::Opener opener{.done_after = answer(never)};
        EXPECT_THROW(crossing::Access::find(searcher, wall, {0, 1}, {4, 1}, {.crossings = 1}, opener), InputError);
    }
    EXPECT_THROW(cross({.crossings = 1, .opened_after = answer(1), .weight = 1.1}), InputError);
    EXPECT_NO_THROW(cross({.crossings = 1, .opened_after = answer(-5)}));  // open since long
}

TEST(Crossing, SaysHowFarItLookedForNothing) {
    const Map wall = map_from_ascii("..a.. ..a.. ..a..");
    const auto find = [&](const CrossingOptions& options) {
        return CrossingSearcher().find(wall, {0, 1}, {4, 1}, options);
    };
    const CrossingResult none = find({});
    EXPECT_EQ(none.status, SearchStatus::no_path);
    EXPECT_EQ(none.lower_bound, std::numeric_limits<double>::infinity());
    const CrossingResult dear = find({.crossings = 1, .length_limit = 3.5});
    EXPECT_EQ(dear.status, SearchStatus::no_path);
    EXPECT_DOUBLE_EQ(dear.lower_bound, 3.5);
    const CrossingResult below = find({.crossings = 1, .length_limit = -3});
    EXPECT_EQ(below.status, SearchStatus::no_path);
    EXPECT_DOUBLE_EQ(below.lower_bound, -3);
}

}  // namespace
}  // namespace waybreaker
