#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "ascii_map.hpp"
#include "flight/brute_force.hpp"
#include "flight/exact.hpp"
#include "flight/local_search.hpp"

namespace waybreaker {
namespace {

void expect_optimal(const World& world) {
    const Flight flight = fly_optimal(world.map, world.start, world.goal, world.ids);
    expect_valid(world.map, world.start, world.goal, world.ids, flight);
    RC_ASSERT(std::abs(flight.length - slow_optimal_length(world.map, world.start, world.goal, world.ids)) < 1e-9);
    RC_ASSERT(flight.length <= fly_nearest(world.map, world.start, world.goal, world.ids).length + 1e-9);
}

RC_GTEST_PROP(FlyOptimal, IsTheShortestPastUpToThreeObstacles, ()) {
    expect_optimal(*arbitrary_world(20, 16, *uniform(0, 4), 6));
}
RC_GTEST_PROP(FlyOptimal, IsTheShortestPastFourObstacles, ()) {
    expect_optimal(*arbitrary_world(12, 9, 4, 3));
}

// In a single row a cell has two neighbours at most, so that brute force can try every order of many.
RC_GTEST_PROP(FlyOptimal, IsTheShortestPastFiveToEightTinyObstacles, ()) {
    expect_optimal(*arbitrary_world(11, 1, *uniform(6, 9), 1));
}
RC_GTEST_PROP(FlyOptimal, IsTheShortestPastFiveSmallObstacles, ()) {
    expect_optimal(*arbitrary_world(7, 2, 5, 1));
}

// The proof must not lean on the tour it is given to start from.
RC_GTEST_PROP(ShortestTour, DoesNotDependOnTheKnownTour, ()) {
    const World world = *arbitrary_world(30, 30, *uniform(1, 7), 9);
    const std::vector<Target> targets = targets_of(world.map, world.ids);
    Tour any;
    for (std::size_t i = 0; i < targets.size(); ++i) any.push_back({i, *rc::gen::elementOf(targets[i].cells)});
    const Tour good = improved_tour(world.start, any, world.goal, targets);
    const auto breaches = [&](const Tour& known) {
        const Tour tour = shortest_tour(world.start, world.goal, targets, known);
        return flight_of(world.start, tour, world.goal, targets).breaches;
    };
    RC_ASSERT(breaches(any) == breaches(good));
}

// Flying the other way round is as long.
RC_GTEST_PROP(FlyOptimal, IsAsLongBackwards, ()) {
    const World world = *arbitrary_world(60, 60, *uniform(1, 9), 15);
    const double there = fly_optimal(world.map, world.start, world.goal, world.ids).length;
    const double back = fly_optimal(world.map, world.goal, world.start, world.ids).length;
    RC_ASSERT(std::abs(there - back) < 1e-9);
}

RC_GTEST_PROP(FlyOptimal, GrowsWithEveryObstacle, ()) {
    World world = *arbitrary_world(60, 60, *uniform(1, 9), 15);
    const double all = fly_optimal(world.map, world.start, world.goal, world.ids).length;
    if (!world.ids.empty()) world.ids.pop_back();
    RC_ASSERT(fly_optimal(world.map, world.start, world.goal, world.ids).length <= all + 1e-9);
}

// For one obstacle it is the paper's rule for n = 1: the first boundary cell with the least |start c| + |c goal|.
RC_GTEST_PROP(FlyOptimal, FollowsThePapersRuleForOneObstacle, ()) {
    const World world = *arbitrary_world(20, 20, 1, 15);
    RC_PRE(!world.ids.empty());
    const auto way = [&](Cell c) { return distance(world.start, c) + distance(c, world.goal); };
    const Cell expected = std::ranges::min(slow_boundary(world.map, {1}), {}, way);
    const Cell at = fly_optimal(world.map, world.start, world.goal, world.ids).breaches.front().at;
    RC_ASSERT(way(at) <= way(expected) + 1e-9);
    if (way(at) == way(expected)) RC_ASSERT(at == expected);
}

Flight fly_optimal_in(std::string_view picture, const std::vector<ObstacleId>& ids) {
    return fly_optimal(map_from_ascii(picture), mark_in_ascii(picture, 'S'), mark_in_ascii(picture, 'G'), ids);
}

TEST(FlyOptimal, FliesStraightPastWhatLiesOnTheWay) {
    const Flight flight = fly_optimal_in(R"(
        ..aa...bb..
        S.aa...bb.G
        ..aa...bb..)",
                                         {{1}, {2}});
    EXPECT_DOUBLE_EQ(flight.length, 10);
    EXPECT_EQ(flight.breaches, (std::vector<BreachPoint>{{{1}, {1, 1}}, {{2}, {6, 1}}}));
}

TEST(FlyOptimal, TurnsAtACellThatBelongsToTwo) {
    // Between a and b one cell touches both, and the detour to it is the shortest.
    const Flight flight = fly_optimal_in(R"(
        .......
        S.....G
        .......
        .aa.bb.)",
                                         {{1}, {2}});
    EXPECT_EQ(flight.breaches, (std::vector<BreachPoint>{{{1}, {3, 2}}, {{2}, {3, 2}}}));
}

TEST(FlyOptimal, DoesNotFlyInOrderOfDistanceFromStart) {
    // b is nearer to start than c, but lies on the way back from it.
    const Flight flight = fly_optimal_in(R"(
        ..c..........
        .............
        .............
        .............
        .b...........
        .............
        S...........G)",
                                         {{1}, {2}});
    EXPECT_EQ(flight.breaches.front().obstacle, ObstacleId{2});
    EXPECT_EQ(flight.breaches.back().obstacle, ObstacleId{1});
}

TEST(FlyOptimal, WorksAtBorderAndCornerOfTheMap) {
    const Flight flight = fly_optimal_in(R"(
        a....b
        .S.G..
        ......
        ..c...)",
                                         {{1}, {2}, {3}});
    EXPECT_EQ(flight.breaches, (std::vector<BreachPoint>{{{1}, {1, 1}}, {{3}, {2, 2}}, {{2}, {4, 1}}}));
}

TEST(FlyOptimal, BreachesARingFromInside) {
    const Flight flight = fly_optimal_in(R"(
        aaaaa..
        a...a..
        a.S.a.G
        a...a..
        aaaaa..)",
                                         {{1}});
    EXPECT_DOUBLE_EQ(flight.length, 4);
    EXPECT_EQ(flight.breaches.front().at, (Cell{3, 2}));
}

TEST(FlyOptimal, ReturnsToAStartThatIsTheGoal) {
    const Map map = map_from_ascii(R"(
        .....a
        ......
        ......
        b.....)");
    const std::vector<ObstacleId> ids{{1}, {2}};
    EXPECT_DOUBLE_EQ(fly_optimal(map, {1, 0}, {1, 0}, ids).length, slow_optimal_length(map, {1, 0}, {1, 0}, ids));
}

TEST(FlyOptimal, WithoutObstaclesFliesStraight) {
    const Flight flight = fly_optimal(map_from_ascii("....."), {0, 0}, {4, 0}, {});
    EXPECT_TRUE(flight.breaches.empty());
    EXPECT_DOUBLE_EQ(flight.length, 4);
}

}  // namespace
}  // namespace waybreaker
