// Outlines of obstacles, filled again, must give back their cells.
#include "site/outline.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "ascii_map.hpp"

namespace waybreaker::site {
namespace {

// Whether a ring runs around a point that lies on no side of it: crossed sides to the right, counted.
bool encloses(const Ring& ring, Cell c) {
    bool inside = false;
    for (std::size_t i = 1; i < ring.size(); ++i) {
        const Point& a = ring[i - 1];
        const Point& b = ring[i];
        if ((a.y > c.y) != (b.y > c.y) && a.x > c.x) inside = !inside;  // sides are upright or level
    }
    return inside;
}

bool covers(const Polygon& polygon, Cell c) {
    return std::count_if(polygon.begin(), polygon.end(), [&](const Ring& ring) { return encloses(ring, c); }) % 2 == 1;
}

void expect_cells(const Map& map) {
    const auto all = outlines(map);
    ASSERT_EQ(all.size(), map.obstacles().size() + 1);
    for (const Obstacle& obstacle : map.obstacles()) {
        EXPECT_EQ(outline(map, obstacle.id), all[obstacle.id.value]) << "alone as among the others";
    }
    for (Cell c; c.y < map.height(); ++c.y) {
        for (c.x = 0; c.x < map.width(); ++c.x) {
            for (std::uint32_t id = 1; id < all.size(); ++id) {
                const auto covering =
                    std::count_if(all[id].begin(), all[id].end(), [&](const Polygon& p) { return covers(p, c); });
                EXPECT_EQ(covering, map.obstacle_at(c) == ObstacleId{id} ? 1 : 0) << id << " at " << c.x << "," << c.y;
            }
        }
    }
}

TEST(Outlines, RunAlongTheSidesOfCells) {
    const auto all = outlines(map_from_ascii(R"(
        ....
        .aa.
        ....)"));
    ASSERT_EQ(all[1].size(), 1U);
    ASSERT_EQ(all[1][0].size(), 1U);
    const Ring& ring = all[1][0][0];
    EXPECT_EQ(ring.size(), 5U);
    for (const Point& point : ring) {
        EXPECT_TRUE(point.x == 0.5 || point.x == 2.5) << point.x;
        EXPECT_TRUE(point.y == 0.5 || point.y == 1.5) << point.y;
    }
}

TEST(Outlines, HaveHolesAndParts) {
    const Map map = map_from_ascii(R"(
        aaaaa.c
        a...ab.
        a.b.abb
        a...a.b
        aaaaacc)");
    EXPECT_EQ(outlines(map)[1].size(), 1U);
    EXPECT_EQ(outlines(map)[1][0].size(), 2U);
    expect_cells(map);
}

RC_GTEST_PROP(Outlines, CoverTheirCellsAndNoOthers, ()) {
    const int width = *rc::gen::inRange(1, 9);
    const int height = *rc::gen::inRange(1, 9);
    const auto labels = *rc::gen::container<std::vector<std::uint32_t>>(std::size_t(width * height),
                                                                        rc::gen::element<std::uint32_t>(0, 0, 1, 2));
    expect_cells(Map::from_labels(width, height, labels));
}

}  // namespace
}  // namespace waybreaker::site
