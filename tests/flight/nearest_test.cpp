#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "ascii_map.hpp"
#include "flight/brute_force.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker {
namespace {

RC_GTEST_PROP(FlyNearest, FollowsThePapersRule, ()) {
    const World world = *arbitrary_world(18, 14, *uniform(0, 6), 5);
    const Flight flight = fly_nearest(world.map, world.start, world.goal, world.ids);
    expect_valid(world.map, world.start, world.goal, world.ids, flight);
    RC_ASSERT(flight.breaches == slow_nearest(world.map, world.start, world.goal, world.ids).breaches);
}

TEST(FlyNearest, PrefersTheCellNearerToStart) {
    const std::string_view picture = R"(
        .......
        .S...G.
        .......
        ..aaa..)";
    const Map map = map_from_ascii(picture);
    const Flight flight = fly_nearest(map, mark_in_ascii(picture, 'S'), mark_in_ascii(picture, 'G'), {{{1}}});
    EXPECT_EQ(flight.breaches, (std::vector<BreachPoint>{{{1}, {1, 2}}}));
}

TEST(FlyNearest, MeasuresToTheSegmentNotTheLine) {
    // The line through start and goal passes the obstacle's right end; the segment ends before.
    const std::string_view picture = R"(
        .........
        S.G......
        .....aaa.
        ...aaa...
        ...aaa...)";
    const Map map = map_from_ascii(picture);
    const Flight flight = fly_nearest(map, mark_in_ascii(picture, 'S'), mark_in_ascii(picture, 'G'), {{{1}}});
    EXPECT_EQ(flight.breaches, (std::vector<BreachPoint>{{{1}, {2, 2}}}));
}

TEST(FlyNearest, IsExactOnTheLargestMap) {
    // Two cells whose offsets from the segment differ by less than a double of their squares can tell.
    const int side = 16384;
    std::vector<std::uint32_t> labels(std::size_t{side} * 3, 0);
    labels[0] = labels[std::size_t{side} * 3 - 1] = 1;
    const Map map = Map::from_labels(side, 3, std::move(labels));
    const Cell start{1, 2};
    const Cell goal{side - 2, 1};
    const Flight flight = fly_nearest(map, start, goal, {{{1}}});
    EXPECT_EQ(flight.breaches, slow_nearest(map, start, goal, {{1}}).breaches);
}

TEST(FlyNearest, TreatsAnObstacleNamedTwiceOnce) {
    const Map map = map_from_ascii(".#.\n...");
    const std::vector<ObstacleId> twice{{1}, {1}};
    EXPECT_EQ(fly_nearest(map, {0, 0}, {2, 0}, twice).breaches.size(), 1U);
    EXPECT_EQ(fly_optimal(map, {0, 0}, {2, 0}, twice).breaches.size(), 1U);
}

TEST(FlyNearest, RefusesAnObstacleThatFillsTheMap) {
    const Map map = map_from_ascii("##\n##");
    const std::vector<ObstacleId> all{{1}};
    EXPECT_THROW(fly_nearest(map, {0, 0}, {1, 1}, all), InputError);
    EXPECT_THROW(fly_optimal(map, {0, 0}, {1, 1}, all), InputError);
}

}  // namespace
}  // namespace waybreaker
