// Line of sight against the slow, obvious one; both are exact, so they agree to the bit.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "ascii_map.hpp"
#include "random_map.hpp"
#include "slow_sight.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker {
namespace {

// All pairs of cells of the map, for one way of moving.
void check_all_pairs(const PlainMap& plain, const Body& body) {
    const Map map(plain.grid());
    const OpenedMap opened(map);
    for (const Cell a : plain.cells()) {
        const bool stands = slow::sees(plain, a, a, body);
        RC_ASSERT(fits(opened, a, body) == stands);
        RC_ASSERT(line_of_sight(opened, a, a, body) == stands);
        for (const Cell b : plain.cells()) {
            const bool sees = slow::sees(plain, a, b, body);
            const bool claimed = line_of_sight(opened, a, b, body);
            if (sees != claimed) {
                RC_LOG() << a.x << ',' << a.y << " to " << b.x << ',' << b.y << ": claimed " << claimed << '\n';
            }
            RC_ASSERT(claimed == sees);
        }
    }
}

RC_GTEST_PROP(LineOfSight, OfTheUnitDiscIsExact, ()) {
    check_all_pairs(*random_map(11, 9), {});
}

RC_GTEST_PROP(LineOfSight, OfOtherDiscsIsExact, ()) {
    const double radius = *rc::gen::element(0.001, 0.2, 0.499, 0.501, 0.707, 0.708, 0.75, 1.0, 1.5, 2.25, 3.7);
    check_all_pairs(*random_map(11, 9), {.radius = radius});
}

// Sparse maps leave a wide disc some room.
RC_GTEST_PROP(LineOfSight, OfWideDiscsIsExactInTheOpen, ()) {
    const double radius = *rc::gen::element(0.501, 0.75, 1.0, 1.118, 1.5, 2.25, 3.7);
    PlainMap plain{*number(8, 16), *number(8, 12), {}};
    plain.obstacles.assign(std::size_t(plain.width) * std::size_t(plain.height), 0);
    plain.obstacles[plain.index(any_cell(plain))] = 1;
    check_all_pairs(plain, {.radius = radius});
}

RC_GTEST_PROP(LineOfSight, OfPointsIsExact, ()) {
    const Corners corners = *rc::gen::element(Corners::cut, Corners::squeeze);
    check_all_pairs(*random_map(11, 9), {.corners = corners});
}

// Lines longer than a word of bits, on opened maps.
RC_GTEST_PROP(LineOfSight, HoldsForLongSegments, ()) {
    const PlainMap closed = *rc::gen::suchThat(random_map(150, 12), [](const PlainMap& m) { return m.width > 60; });
    const Map map(*number(0, 1) == 0 ? closed.grid() : closed.grid().transposed());
    const std::vector<ObstacleId> removed = some_obstacles(map, 6);
    const PlainMap open = plain(map, removed);
    const OpenedMap opened(map, removed);
    const Body body{.corners = any_corners()};
    for (int i = 0; i < 40; ++i) {
        const Cell a = any_free_cell(open);
        const Cell b = any_free_cell(open);
        const bool sees = slow::sees(open, a, b, body);
        RC_ASSERT(line_of_sight(opened, a, b, body) == sees);
        RC_ASSERT(line_of_sight(opened, b, a, body) == sees);
    }
}

TEST(LineOfSight, TouchesButDoesNotCross) {
    // A disc of radius 0.5 that moves along a wall touches it all the way.
    const Map wall = map_from_ascii(R"(
        .....
        #####
        .....)");
    EXPECT_TRUE(line_of_sight(OpenedMap(wall), {0, 0}, {4, 0}));
    EXPECT_FALSE(line_of_sight(OpenedMap(wall), {0, 0}, {0, 2}));
    // Cell (2, 0) reaches to exactly half a cell from the segment (0, 0)-(4, 3), which is 5 long; (1, 0) reaches
    // further.
    const Map touched = map_from_ascii(R"(
        ..#..
        .....
        .....
        .....)");
    EXPECT_TRUE(line_of_sight(OpenedMap(touched), {0, 0}, {4, 3}));
    EXPECT_FALSE(line_of_sight(OpenedMap(touched), {0, 0}, {4, 3}, {.radius = 0.501}));
    const Map crossed = map_from_ascii(R"(
        .#...
        .....
        .....
        .....)");
    EXPECT_FALSE(line_of_sight(OpenedMap(crossed), {0, 0}, {4, 3}));
    const Map one_side = map_from_ascii(R"(
        ..
        #.)");
    EXPECT_FALSE(line_of_sight(OpenedMap(one_side), {0, 0}, {1, 1}));
    EXPECT_TRUE(line_of_sight(OpenedMap(one_side), {0, 0}, {1, 1}, {.corners = Corners::cut}));
    const Map both_sides = map_from_ascii(R"(
        .#
        #.)");
    EXPECT_FALSE(line_of_sight(OpenedMap(both_sides), {0, 0}, {1, 1}, {.corners = Corners::cut}));
    EXPECT_TRUE(line_of_sight(OpenedMap(both_sides), {0, 0}, {1, 1}, {.corners = Corners::squeeze}));
}

TEST(LineOfSight, SeesNothingOffTheMap) {
    const Map map{Grid(64, 64)};
    const OpenedMap opened(map);
    for (const Cell off :
         {Cell{-1, 2}, {-100, 2}, {64, 2}, {1 << 30, 2}, {2, -1}, {2, -(1 << 30)}, {2, 64}, {2, 9999}}) {
        for (const Body& body : {Body{}, point_body, Body{.radius = 2}}) {
            EXPECT_FALSE(fits(opened, off, body));
            EXPECT_FALSE(line_of_sight(opened, off, {20, 20}, body));
            EXPECT_FALSE(line_of_sight(opened, {20, 20}, off, body));
        }
    }
}

TEST(LineOfSight, RefusesImpossibleAgents) {
    EXPECT_THROW(validate(Body{.radius = 0.0004}), InputError);
    EXPECT_THROW(validate(Body{.radius = 32.001}), InputError);
    EXPECT_THROW(validate(Body{.radius = std::nan("")}), InputError);
    EXPECT_THROW(validate(Body{.radius = 1, .corners = Corners::cut}), InputError);
    EXPECT_NO_THROW(validate(Body{.radius = 32}));
}

}  // namespace
}  // namespace waybreaker
