// The oracle itself, on maps small enough to be worked out by hand.
#include <gtest/gtest.h>

#include <cmath>

#include "ascii_map.hpp"
#include "slow_crossing.hpp"

namespace waybreaker {
namespace {

using slow::CrossingOracle;
using slow::Set;

// The shortest path from S to G when the obstacles shown as `gone` are gone.
double shortest(Body body, std::string_view picture, std::string_view gone = "", bool relaxed = false) {
    const Map map = map_from_ascii(picture);
    Set set = 0;
    for (const char letter : gone) set |= Set{1} << map.obstacle_at(mark_in_ascii(picture, letter)).value;
    return CrossingOracle(plain(map), body, relaxed, mark_in_ascii(picture, 'S'), mark_in_ascii(picture, 'G'))
        .shortest(set);
}

const double root2 = std::sqrt(2.0);

TEST(CrossingOracle, GoesStraightWhereNothingStands) {
    EXPECT_DOUBLE_EQ(shortest(Body{}, "S... .... ...G"), std::hypot(3, 2));
    EXPECT_DOUBLE_EQ(shortest(point_body, "S... .... ...G"), std::hypot(3, 2));
    EXPECT_DOUBLE_EQ(shortest(point_body, "S.a. ..a. ..aG", "a"), std::hypot(3, 2));
    EXPECT_DOUBLE_EQ(shortest(Body{}, "S.a. ..a. ..aG", "a"), std::hypot(3, 2));
}

TEST(CrossingOracle, BendsAtCentresOrAtCorners) {
    const std::string_view picture = R"(
        S.a.G
        .....)";
    EXPECT_DOUBLE_EQ(shortest(Body{}, picture), 2 + 2 * root2);                     // (1, 1) and (3, 1)
    EXPECT_DOUBLE_EQ(shortest(point_body, picture), 1 + 2 * std::hypot(1.5, 0.5));  // (1.5, 0.5) and (2.5, 0.5)
    EXPECT_DOUBLE_EQ(shortest(Body{}, picture, "a"), 4);
    EXPECT_DOUBLE_EQ(shortest(point_body, picture, "a"), 4);
}

TEST(CrossingOracle, TouchesTheSidesOfANarrowCorridor) {
    const std::string_view picture = R"(
        aaaaa
        S...G
        bbbbb)";
    EXPECT_DOUBLE_EQ(shortest(Body{}, picture), 4);
    EXPECT_DOUBLE_EQ(shortest(point_body, picture), 4);
}

TEST(CrossingOracle, SlipsBetweenDiagonalNeighboursOnlyAsAPoint) {
    const std::string_view picture = R"(
        S#
        #G)";
    EXPECT_DOUBLE_EQ(shortest(point_body, picture), root2);
    EXPECT_EQ(shortest(Body{}, picture), CrossingOracle::nowhere);
    const std::string_view ring = R"(
        ..a..
        .aSa.
        ..a.G)";
    EXPECT_DOUBLE_EQ(shortest(point_body, ring), root2 / 2 + std::hypot(1.5, 0.5));
    EXPECT_EQ(shortest(Body{}, ring), CrossingOracle::nowhere);
}

TEST(CrossingOracle, PinchesTheRelaxedBodyWhereTwoCellsTouchAtACorner) {
    const std::string_view slanted = R"(
        Sa
        bG)";
    EXPECT_EQ(shortest(Body{}, slanted, "", true), CrossingOracle::nowhere);
    EXPECT_DOUBLE_EQ(shortest(Body{}, slanted, "a", true), root2);
    const std::string_view along = R"(
        S.aaa
        bb..G)";
    EXPECT_DOUBLE_EQ(shortest(point_body, along), std::hypot(1.5, 0.5) + std::hypot(2.5, 0.5));
    EXPECT_EQ(shortest(Body{}, along, "", true), CrossingOracle::nowhere);
    const std::string_view around = R"(
        S.a.
        bb.G)";
    EXPECT_EQ(shortest(Body{}, around, "", true), CrossingOracle::nowhere);
}

TEST(CrossingOracle, CutsNoCornerAsASquare) {
    const std::string_view picture = R"(
        S#
        .G)";
    EXPECT_DOUBLE_EQ(shortest(Body{}, picture), 2);
    EXPECT_DOUBLE_EQ(shortest(point_body, picture), root2);
}

TEST(CrossingOracle, StaysOnTheMap) {
    const std::string_view picture = R"(
        .a.
        SaG
        .a.)";
    EXPECT_EQ(shortest(point_body, picture), CrossingOracle::nowhere);
    EXPECT_EQ(shortest(Body{}, picture), CrossingOracle::nowhere);
    EXPECT_DOUBLE_EQ(shortest(point_body, picture, "a"), 2);
    EXPECT_DOUBLE_EQ(shortest(Body{}, picture, "a"), 2);
}

// Both reach from edge to edge. Without a, the way leads along b; where both stand, their border is closed.
TEST(CrossingOracle, SlidesBetweenTwoObstaclesOnceOneIsGone) {
    const std::string_view picture = R"(
        ..aa..
        ..aa..
        S.bb.G
        ..bb..)";
    EXPECT_EQ(shortest(point_body, picture), CrossingOracle::nowhere);
    EXPECT_DOUBLE_EQ(shortest(point_body, picture, "a"), 2 + 2 * std::hypot(1.5, 0.5));
    EXPECT_DOUBLE_EQ(shortest(point_body, picture, "b"), 5);
    EXPECT_EQ(shortest(Body{}, picture), CrossingOracle::nowhere);
    EXPECT_DOUBLE_EQ(shortest(Body{}, picture, "a"), 3 + 2 * root2);
    EXPECT_DOUBLE_EQ(shortest(Body{}, picture, "b"), 5);
}

TEST(CrossingOracle, CrossesAnObstacleTwiceForTheSamePrice) {
    const std::string_view picture = R"(
        S.a.a.G
        ..aaa..
        ..aaa..)";
    EXPECT_EQ(shortest(Body{}, picture), CrossingOracle::nowhere);
    EXPECT_DOUBLE_EQ(shortest(Body{}, picture, "a"), 6);
    EXPECT_DOUBLE_EQ(shortest(point_body, picture, "a"), 6);
}

TEST(CrossingOracle, LeavesNestedRingsOneByOne) {
    const std::string_view picture = R"(
        aaaaaaa.
        a.....a.
        a.bbb.a.
        a.bSb.aG
        a.bbb.a.
        a.....a.
        aaaaaaa.)";
    EXPECT_EQ(shortest(point_body, picture), CrossingOracle::nowhere);
    EXPECT_EQ(shortest(point_body, picture, "a"), CrossingOracle::nowhere);
    EXPECT_EQ(shortest(Body{}, picture, "b"), CrossingOracle::nowhere);
    EXPECT_DOUBLE_EQ(shortest(Body{}, picture, "ab"), 4);
}

TEST(CrossingOracle, OpensNoEndInsideAnObstacle) {
    const Map map = map_from_ascii("aa..");
    const CrossingOracle oracle(plain(map), Body{}, false, {0, 0}, {3, 0});
    EXPECT_EQ(oracle.shortest(0), CrossingOracle::nowhere);
    EXPECT_DOUBLE_EQ(oracle.shortest(2), 3);
}

TEST(CrossingOracle, ListsSetsFromSmallToLarge) {
    EXPECT_EQ(slow::subsets(0b10110, 2), (std::vector<Set>{0, 0b10, 0b100, 0b10000, 0b110, 0b10010, 0b10100}));
    EXPECT_EQ(slow::subsets(0b10110, 0), std::vector<Set>{0});
    EXPECT_EQ(slow::subsets(0b10110, 7).size(), 8U);
}

}  // namespace
}  // namespace waybreaker
