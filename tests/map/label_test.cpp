// Labelling against a flood fill.
#include "map/label.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "ascii_map.hpp"
#include "random_map.hpp"

namespace waybreaker {
namespace {

// Fills obstacle after obstacle in scan order.
std::vector<std::uint32_t> flood_fill(const PlainMap& map, Connectivity connectivity) {
    std::vector<std::uint32_t> labels(map.obstacles.size(), 0);
    std::uint32_t last = 0;
    for (const Cell seed : map.cells()) {
        if (!map.blocked(seed) || labels[map.index(seed)] != 0) continue;
        ++last;
        std::vector<Cell> rest{seed};
        while (!rest.empty()) {
            const Cell c = rest.back();
            rest.pop_back();
            if (!map.contains(c) || !map.blocked(c) || labels[map.index(c)] != 0) continue;
            labels[map.index(c)] = last;
            for (int dy = -1; dy <= 1; ++dy) {
                for (int dx = -1; dx <= 1; ++dx) {
                    const bool side = std::abs(dx) + std::abs(dy) == 1;
                    if (side || connectivity == Connectivity::eight) rest.push_back({c.x + dx, c.y + dy});
                }
            }
        }
    }
    return labels;
}

RC_GTEST_PROP(Label, IsAFloodFill, ()) {
    const PlainMap plain = *random_map(*rc::gen::element(12, 130), 14);
    const Connectivity connectivity = *rc::gen::element(Connectivity::four, Connectivity::eight);
    RC_ASSERT(label_components(plain.grid(), connectivity) == flood_fill(plain, connectivity));
}

// Dense and spotted: many runs that join late.
RC_GTEST_PROP(Label, JoinsWhatMeetsLater, ()) {
    PlainMap plain{*number(1, 20), *number(1, 20), {}};
    const int percent = *number(40, 75);
    for (int i = 0; i < plain.width * plain.height; ++i) plain.obstacles.push_back(*number(0, 99) < percent ? 1 : 0);
    const Connectivity connectivity = *rc::gen::element(Connectivity::four, Connectivity::eight);
    RC_ASSERT(label_components(plain.grid(), connectivity) == flood_fill(plain, connectivity));
}

TEST(Label, FollowsSpirals) {
    const Map spiral = map_from_ascii(R"(
        #######
        #.....#
        #.###.#
        #.#...#
        #.#####
        #......
        #######)");
    EXPECT_EQ(spiral.obstacles().size(), 1U);
}

TEST(Label, ParsDiagonalNeighboursUnlessToldOtherwise) {
    constexpr std::string_view picture = R"(
        #..#
        .##.
        .##.
        #..#)";
    EXPECT_EQ(map_from_ascii(picture, Connectivity::four).obstacles().size(), 5U);
    EXPECT_EQ(map_from_ascii(picture, Connectivity::eight).obstacles().size(), 1U);
}

TEST(Label, KnowsEmptyAndFullMaps) {
    Grid grid(70, 3);
    EXPECT_TRUE(Map(grid).obstacles().empty());
    for (int y = 0; y < 3; ++y) {
        for (int x = 0; x < 70; ++x) grid.set_blocked({x, y}, true);
    }
    const Map full(grid);
    ASSERT_EQ(full.obstacles().size(), 1U);
    EXPECT_EQ(full.obstacles()[0].cells, 210U);
    EXPECT_TRUE(full.boundary({1}).empty());
}

}  // namespace
}  // namespace waybreaker
