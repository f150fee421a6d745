// The executor's own geometry: bodies against cells, and against each other.
#include "rehearse/trail.hpp"

#include <gtest/gtest.h>

namespace waybreaker::rehearsal {
namespace {

Trail driven(const std::string& agent, double radius, const std::vector<Waypoint>& path) {
    Trail trail{.agent = agent, .radius = radius};
    for (const Waypoint& p : path) trail.add({p.x, p.y}, p.t);
    return trail;
}

TEST(Trail, TouchingIsNoOverlap) {
    const Map map = Map::from_rows({".....", "..A..", "....."});
    const auto faults = [&](const std::vector<Waypoint>& path, const Events& events = {}) {
        return faults_of(map, events, std::vector{driven("rover", 0.5, path)}, 0, true).size();
    };
    EXPECT_EQ(faults({{0, 0, 0}, {4, 0, 4}}), 0U);
    EXPECT_EQ(faults({{0, 1, 0}, {1, 1, 1}}), 0U);
    EXPECT_EQ(faults({{0, 1, 0}, {1.01, 1, 1}}), 1U);
    EXPECT_EQ(faults({{0, 0, 0}, {4, 1, 4}}), 1U);
    EXPECT_EQ(faults({{0, 1, 0}, {4, 1, 4}}, {.opened = {{{1}, 1}}}), 0U);
    EXPECT_EQ(faults({{0, 1, 0}, {4, 1, 4}}, {.opened = {{{1}, 1.01}}}), 1U);
    EXPECT_EQ(faults({{0, 0, 0}, {4, 0, 4}}, {.rubble = {{{{2, 0}}, 1.9}}}), 1U);
    EXPECT_EQ(faults({{0, 0, 0}, {4, 0, 4}}, {.rubble = {{{{2, 0}}, 3}}}), 0U);
}

TEST(Trail, PointsPassBetweenDiagonalNeighbours) {
    const Map map = Map::from_rows({".A", "B."});
    EXPECT_TRUE(faults_of(map, {}, std::vector{driven("rover", 0, {{0, 0, 0}, {1, 1, 1}})}, 0, true).empty());
    EXPECT_FALSE(faults_of(map, {}, std::vector{driven("rover", 0, {{0, 0, 0}, {1, 0.5, 1}})}, 0, true).empty());
}

TEST(Trail, PairsOverlapWhereTheyAreAtOneTime) {
    const Map map = Map::from_rows({".....", ".....", "....."});
    const auto faults = [&](const std::vector<Waypoint>& a, const std::vector<Waypoint>& b, bool stay = true) {
        return faults_of(map, {}, std::vector{driven("a", 0.5, a), driven("b", 0.5, b)}, 0, stay).size();
    };
    EXPECT_EQ(faults({{0, 1, 0}, {4, 1, 4}}, {{0, 0, 0}, {4, 0, 4}}), 0U);
    EXPECT_EQ(faults({{0, 1, 0}, {4, 1, 4}}, {{4, 1, 0}, {0, 1, 4}}), 1U);
    EXPECT_EQ(faults({{0, 1, 0}, {4, 1, 4}}, {{2, 0, 0}, {2, 0, 1.5}, {2, 2, 3.5}}), 1U);
    EXPECT_EQ(faults({{0, 1, 0}, {4, 1, 4}}, {{2, 0, 0}, {2, 0, 3.5}, {2, 2, 5.5}}), 0U);
    // It has left before the other comes by, or stands there for ever.
    EXPECT_EQ(faults({{0, 1, 0}, {2, 1, 2}}, {{2, 0, 0}, {2, 0, 4}, {2, 2, 6}}, false), 0U);
    EXPECT_EQ(faults({{0, 1, 0}, {2, 1, 2}}, {{2, 0, 0}, {2, 0, 4}, {2, 2, 6}}, true), 1U);
}

TEST(Trail, FirstOverlapIsWhereTheDiscComesNear) {
    const Map map = Map::from_rows({"...A."});
    EXPECT_NEAR(first_overlap(map, {1}, {0, 0}, {4, 0}, 0.5).value_or(-1), 0.5, 1e-5);
    EXPECT_NEAR(first_overlap(map, {1}, {0, 0}, {4, 0}, 0).value_or(-1), 2.5 / 4, 1e-5);
    EXPECT_FALSE(first_overlap(map, {1}, {0, 0}, {2, 0}, 0.5));
}

}  // namespace
}  // namespace waybreaker::rehearsal
