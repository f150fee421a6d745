#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "input_error.hpp"
#include "zones/cells.hpp"
#include "zones/slow_zones.hpp"

namespace waybreaker {
namespace {

Zone zone_of(std::vector<std::vector<Point>> polygon) {
    return {.polygon = std::move(polygon), .name = "harbour"};
}

std::string fault_of(const Zone& zone) {
    return input_error([&] { validate(zone, 3); });
}

TEST(Zone, IsNamed) {
    EXPECT_EQ(name_of(zone_of({}), 2), "the zone 'harbour'");
    EXPECT_EQ(name_of(Zone{}, 2), "zone 2");
    EXPECT_EQ(name_of(Zone{.from = 10, .until = 20.5}, 2), "zone 2 (from 10 until 20.5)");
    EXPECT_EQ(name_of(Zone{.name = "harbour", .until = 20}, 2), "the zone 'harbour' (until 20)");
    EXPECT_EQ(name_of(Zone{.from = 10}, 2), "zone 2 (from 10)");
}

TEST(Zone, HoldsBetweenItsTimes) {
    Zone zone = zone_of({{{0, 0}, {4, 0}, {4, 4}}});
    EXPECT_FALSE(zone.has_window());
    EXPECT_TRUE(zone.holds_at(0));
    zone.until = 20;
    EXPECT_EQ(fault_of(zone), "");
    EXPECT_TRUE(zone.has_window() && zone.holds_at(1) && !zone.holds_at(20));
    zone.from = 10;
    EXPECT_TRUE(zone.has_window() && !zone.holds_at(10) && zone.holds_at(10.5));
    zone.from = 20;
    EXPECT_EQ(fault_of(zone),
              "the zone 'harbour' (from 20 until 20) ends before it holds; let 'until' be after 'from'");
    zone.from = -1;
    EXPECT_EQ(fault_of(zone),
              "the zone 'harbour' (until 20) begins to hold at no time of a mission; let 'from' be 0 or more");
    zone.from = std::nan("");
    EXPECT_NE(fault_of(zone), "");
    zone.from = 0;
    zone.until = std::nan("");
    EXPECT_NE(fault_of(zone), "");
}

TEST(Zone, HasAPolygonOfThreeCornersOrMore) {
    EXPECT_EQ(fault_of(zone_of({})), "the zone 'harbour' has no polygon; give its corners");
    EXPECT_EQ(fault_of(zone_of({{{0, 0}, {4, 0}}})), "the zone 'harbour' has a polygon of fewer than three corners");
    EXPECT_EQ(fault_of(zone_of({{{0, 0}, {4, 0}, {4, 1e-5}}})),
              "the zone 'harbour' has a polygon of fewer than three corners");
    Zone unnamed = zone_of({{}});
    unnamed.name.clear();
    EXPECT_EQ(fault_of(unnamed), "zone 3 has a polygon of fewer than three corners");
    EXPECT_EQ(fault_of(zone_of({{{0, 0}, {4, 0}, {4, 1e9}}})),
              "the zone 'harbour' has a corner at 4,1e+09, farther than 65536 cells away; is it for this map?");
    EXPECT_NE(fault_of(zone_of({{{0, 0}, {4, 0}, {std::nan(""), 4}}})), "");
}

TEST(Zone, IsSimple) {
    const std::string crossed = "the zone 'harbour' has a polygon that crosses or touches itself near ";
    EXPECT_TRUE(fault_of(zone_of({{{0, 0}, {4, 4}, {4, 0}, {0, 4}}})).starts_with(crossed));          // a bow tie
    EXPECT_TRUE(fault_of(zone_of({{{0, 0}, {8, 0}, {4, 0}, {4, 4}}})).starts_with(crossed));          // a spike
    EXPECT_TRUE(fault_of(zone_of({{{0, 0}, {8, 0}, {8, 4}, {4, 0}, {0, 4}}})).starts_with(crossed));  // a touch
    EXPECT_EQ(fault_of(zone_of({{{0, 0}, {4, 0}, {8, 0}, {8, 4}, {0, 4}}})), "");  // a straight angle
    EXPECT_EQ(fault_of(zone_of({{{0, 0}, {0, 4}, {4, 4}}})), "");                  // either way round
    EXPECT_EQ(fault_of(zone_of({{{0, 0}, {9, 0}, {9, 9}, {0, 9}}, {{2, 2}, {4, 2}, {4, 4}}})), "");
    EXPECT_EQ(fault_of(zone_of({{{0, 0}, {9, 0}, {9, 9}, {0, 9}}, {{12, 2}, {14, 2}, {14, 4}}})),
              "the zone 'harbour' has a hole outside its outline");
    EXPECT_EQ(fault_of(zone_of({{{0, 0}, {9, 0}, {9, 9}, {0, 9}}, {{1, 1}, {8, 1}, {8, 8}}, {{6, 2}, {7, 2}, {7, 3}}})),
              "the zone 'harbour' has a hole in a hole; make what is in it a zone of its own");
    EXPECT_TRUE(fault_of(zone_of({{{0, 0}, {9, 0}, {9, 9}, {0, 9}}, {{5, 5}, {12, 5}, {12, 7}}})).starts_with(crossed));
}

RC_GTEST_PROP(ZoneCells, AreThoseWhoseAreaItsInteriorMeets, ()) {
    Zone zone = any_zone(20);
    // Corners on corners of cells as well, and on their sides.
    const double shift = *rc::gen::elementOf(std::vector<double>{0, 0.25, 0.5});
    for (Point& p : zone.polygon.front()) p = {p.x + shift, p.y - shift};
    RC_PRE(is_valid(zone));
    std::vector<Cell> expected;
    for (int y = 0; y < 20; ++y) {
        for (int x = 0; x < 20; ++x) {
            if (area_within(zone.polygon.front(), {x, y}) > 1e-9) expected.push_back({x, y});
        }
    }
    RC_ASSERT(zones::cells_in(zone, 20, 20) == expected);
}

TEST(ZoneCells, LeaveHolesOut) {
    const Zone zone =
        zone_of({{{-0.5, -0.5}, {4.5, -0.5}, {4.5, 2.5}, {-0.5, 2.5}}, {{0.5, 0.5}, {2, 0.5}, {2, 1.5}, {0.5, 1.5}}});
    validate(zone, 1);
    std::vector<Cell> cells = zones::cells_in(zone, 20, 20);
    EXPECT_EQ(cells.size(), 14U);
    EXPECT_FALSE(std::ranges::count(cells, Cell{1, 1}));
    EXPECT_TRUE(std::ranges::count(cells, Cell{2, 1}));  // half of it is hole
}

}  // namespace
}  // namespace waybreaker
