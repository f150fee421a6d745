// What paths lead over, on maps small enough to measure by hand.
#include "site/surface.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "ascii_map.hpp"

namespace waybreaker::site {
namespace {

// A street along row 2, a bank along row 4; w: water.
struct Shore {
    Map map = map_from_ascii(R"(
        ........
        ........
        ........
        ........
        ........
        ........
        wwwwwwww
        wwwwwwww)");
    Annotations known{.kinds = {ObstacleKind::unknown, ObstacleKind::water}, .ways = {{{0, 2}, 4}, {{6, 2}, 2}}};

    Surface along(const std::vector<Point>& path, double cell_size = 2) const {
        return SurfaceMap(map, known, cell_size).along(path);
    }
};

void expect_lengths(const Surface& surface, double ways, double off_ways, double unknown) {
    EXPECT_NEAR(surface.ways, ways, 1e-12);
    EXPECT_NEAR(surface.off_ways, off_ways, 1e-12);
    EXPECT_NEAR(surface.unknown, unknown, 1e-12);
}

TEST(Surface, IsMeasuredWhereThePathCrossesTheEdgesOfCells) {
    const Shore shore;
    expect_lengths(shore.along({{0, 2}, {7, 2}}), 5, 2, 0);  // the gap is two cells
    expect_lengths(shore.along({{7, 2}, {0, 2}}), 5, 2, 0);  // either way
    expect_lengths(shore.along({{1, 0}, {1, 5}}), 1, 4, 0);  // across
    const double slant = std::hypot(2, 4);
    expect_lengths(shore.along({{1, 0}, {3, 4}}), slant / 4, slant * 3 / 4, 0);
    const double corner = std::sqrt(2);
    expect_lengths(shore.along({{0, 0}, {3, 3}}), corner, 2 * corner, 0);  // through corners of cells
    expect_lengths(shore.along({{2, 2}, {2, 2}}), 0, 0, 0);                // a wait
    expect_lengths(shore.along({{3, 3}}), 0, 0, 0);
}

TEST(Surface, BetweenTwoCellsIsThatOfEither) {
    const Shore shore;
    expect_lengths(shore.along({{0.5, 1.5}, {2.5, 1.5}}), 2, 0, 0);
    expect_lengths(shore.along({{0.5, 2.5}, {2.5, 2.5}}), 2, 0, 0);
    expect_lengths(shore.along({{3.5, 0.5}, {3.5, 4.5}}), 1, 3, 0);
    expect_lengths(shore.along({{-0.5, 0.5}, {-0.5, 4.5}}), 1, 3, 0);  // along the edge of the map
}

TEST(Surface, OfUnknownGroundIsNeitherWayNorOffIt) {
    Shore shore;
    shore.known.unknown = {{{3, 2}, 2}};
    expect_lengths(shore.along({{0, 2}, {7, 2}}), 4, 1, 2);
    shore.known.unknown = {};
    shore.known.tags["occupancy=unknown"] = {ObstacleId{1}};  // and removed, as nothing that is unknown can be
    expect_lengths(shore.along({{0, 5}, {0, 7}}), 0, 0.5, 1.5);
}

TEST(Surface, IsNearWaterFiveMetresFromIt) {
    const Shore shore;
    // From the centres of cells in rows 5, 4, 3 it is 1, 3, 5 m to the water, of 2 m each.
    EXPECT_NEAR(*shore.along({{1, 0}, {1, 5}}).near_water, 2.5, 1e-12);
    EXPECT_NEAR(*shore.along({{1, 0}, {1, 5}}, 2.5).near_water, 1.5, 1e-12);
    EXPECT_NEAR(*shore.along({{1, 0}, {1, 5}}, 20).near_water, 0, 1e-12);
    EXPECT_NEAR(*shore.along({{1, 3}, {7, 3}}).near_water, 6, 1e-12);
    EXPECT_FALSE(shore.along({{1, 3}, {7, 3}}, 0.04).near_water);
    Shore dry;
    dry.known.kinds.clear();
    EXPECT_EQ(dry.along({{1, 3}, {7, 3}}).near_water, 0);
}

TEST(Surface, IsOneLineForPeople) {
    EXPECT_EQ(surface_text({.ways = 590, .off_ways = 32, .near_water = 20}, 2),
              "1180 m on ways, 64 m off ways; 40 m within 5 m of water");
    EXPECT_EQ(surface_text({.ways = 5, .off_ways = 0, .unknown = 7, .near_water = 0.2}, 2),
              "10 m on ways, 0 m off ways, 14 m on unknown ground");
    EXPECT_EQ(surface_text({.ways = 5, .near_water = std::nullopt}, 2), "10 m on ways, 0 m off ways");
    Surface sum{.ways = 1, .off_ways = 2, .unknown = 3, .near_water = 4};
    sum += sum;
    EXPECT_EQ(sum, (Surface{.ways = 2, .off_ways = 4, .unknown = 6, .near_water = 8}));
}

}  // namespace
}  // namespace waybreaker::site
