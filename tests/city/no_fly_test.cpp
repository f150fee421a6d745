// No-fly zones of map data, drawn in cells.
#include "city/no_fly.hpp"

#include <cpl_vsi.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "city/osm_drawing.hpp"
#include "input_error.hpp"

namespace waybreaker::city {
namespace {

constexpr double metres = 2;  // of a cell
const ImportOptions window{.longitude = 13.4, .latitude = 52.52, .size = 80, .cell = metres, .section = 0};

class NoFly : public testing::Test {
  protected:
    ~NoFly() override { VSIRmdirRecursive("/vsimem/no_fly_test"); }

    static std::vector<Zone> zones_of(const OsmDrawing& drawing, double clearance) {
        const std::string path = "/vsimem/no_fly_test/town.osm";
        const std::string text = drawing.xml();
        VSILFILE* file = VSIFOpenL(path.c_str(), "wb");
        VSIFWriteL(text.data(), 1, text.size(), file);
        VSIFCloseL(file);
        return no_fly_zones(path, window, clearance);
    }
};

// West, north, east, south.
std::vector<double> bounds_of(const Zone& zone) {
    const auto [west, east] = std::ranges::minmax(zone.polygon.front(), {}, &Point::x);
    const auto [north, south] = std::ranges::minmax(zone.polygon.front(), {}, &Point::y);
    return {west.x, north.y, east.x, south.y};
}

void expect_near(const std::vector<double>& is, const std::vector<double>& wanted, double by) {
    ASSERT_EQ(is.size(), wanted.size());
    for (std::size_t i = 0; i < is.size(); ++i) EXPECT_NEAR(is[i], wanted[i], by) << i;
}

TEST_F(NoFly, AreWhatAircraftKeepClearOf) {
    OsmDrawing town(window);
    town.area("aeroway=aerodrome|name=Tempelhof", box(2, 2, 12, 10))
        .area("amenity=prison", box(20, 2, 26, 8))
        .area("military=training_area", box(2, 20, 12, 30))
        .area("landuse=military|ref=B7", box(20, 20, 26, 26))
        .area("military=bunker", box(30, 30, 33, 33))
        .area("aeroway=hangar", box(4, 4, 6, 6))
        .area("building=yes|aeroway=no", box(34, 2, 36, 4));
    const std::vector<Zone> zones = zones_of(town, 0);
    std::vector<std::string> names;
    for (std::size_t i = 0; i < zones.size(); ++i) {
        names.push_back(zones[i].name);
        EXPECT_EQ(zones[i].kind, ZoneKind::no_fly);
        EXPECT_NO_THROW(validate(zones[i], i + 1));
    }
    EXPECT_EQ(names, (std::vector<std::string>{"Tempelhof", "prison", "military training area", "B7"}));
    expect_near(bounds_of(zones.front()), {2, 2, 12, 10}, 0.01);
    EXPECT_EQ(zones.front().polygon.front().size(), 4U);
}

// To half a cell, by which outlines are simplified.
TEST_F(NoFly, ReachAsFarAsTheClearance) {
    OsmDrawing town(window);
    town.point("aeroway=helipad", {20, 20}).area("amenity=prison", box(2, 2, 4, 4));
    const std::vector<Zone> zones = zones_of(town, 5 * metres);
    ASSERT_EQ(zones.size(), 2U);
    EXPECT_EQ(zones[0].name, "helipad");
    expect_near(bounds_of(zones[0]), {15, 15, 25, 25}, 0.5);
    for (const Point corner : zones[0].polygon.front()) EXPECT_NEAR(distance(corner, Point(20, 20)), 5, 0.5);
    // Cut off beyond the map, whose first cell is at 0.
    expect_near(bounds_of(zones[1]), {-2.5, -2.5, 9, 9}, 0.5);
}

TEST_F(NoFly, BeyondTheWindowAreNone) {
    OsmDrawing town(window);
    town.point("aeroway=helipad", {60, 20}).area("building=yes", box(2, 2, 4, 4));
    EXPECT_TRUE(zones_of(town, 5 * metres).empty());
    EXPECT_EQ(zones_of(town, 30 * metres).size(), 1U);
}

TEST_F(NoFly, HaveNoMoreCornersThanCanBePlannedWith) {
    OsmDrawing town(window);
    for (int i = 0; i < 200; ++i) town.point("aeroway=helipad", {2.0 + 2 * (i % 18), 2.0 + 3 * double(i / 18)});
    std::size_t corners = 0;
    for (const Zone& zone : zones_of(town, 10 * metres)) corners += zone.polygon.front().size();
    EXPECT_GT(corners, 600U);
    EXPECT_LE(corners, most_zone_corners);
    for (int i = 0; i < 600; ++i) town.point("aeroway=helipad", {2.0 + i % 36, 2.0 + 2 * double(i / 36)});
    EXPECT_NE(input_error([&] { (void)zones_of(town, 10 * metres); }).find("more no-fly zones"), std::string::npos);
}

}  // namespace
}  // namespace waybreaker::city
