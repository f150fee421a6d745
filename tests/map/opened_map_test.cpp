#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <concepts>

#include "ascii_map.hpp"
#include "random_map.hpp"

namespace waybreaker {
namespace {

// A map that is gone when the line ends cannot be looked at.
static_assert(std::constructible_from<OpenedMap, const Map&>);
static_assert(std::constructible_from<OpenedMap, Map&, std::vector<ObstacleId>>);
static_assert(!std::constructible_from<OpenedMap, Map>);
static_assert(!std::constructible_from<OpenedMap, const Map>);
static_assert(!std::constructible_from<OpenedMap, Map, std::vector<ObstacleId>>);

bool bit(const std::uint64_t* line, int position) {
    return ((line[(position + 1) / 64] >> ((position + 1) % 64)) & 1U) != 0;
}

// Cells, rows and columns, frame included.
void check_same_world(const OpenedMap& opened, const PlainMap& expected) {
    RC_ASSERT(opened.width() == expected.width);
    RC_ASSERT(opened.height() == expected.height);
    for (int y = -1; y <= expected.height; ++y) {
        for (int x = -1; x <= expected.width; ++x) {
            const bool blocked = expected.blocked({x, y});
            RC_ASSERT(opened.blocked({x, y}) == blocked);
            RC_ASSERT(bit(opened.row(y), x) == blocked);
            RC_ASSERT(bit(opened.column(x), y) == blocked);
        }
    }
}

RC_GTEST_PROP(OpenedMap, IsTheMapWithoutTheObstacles, ()) {
    const Map map((*random_map(*rc::gen::element(14, 140), *rc::gen::element(14, 70))).grid());
    std::vector<ObstacleId> removed = some_obstacles(map, 5);
    const OpenedMap opened(map, removed);
    check_same_world(opened, plain(map, removed));
    std::sort(removed.begin(), removed.end());
    removed.erase(std::unique(removed.begin(), removed.end()), removed.end());
    RC_ASSERT(std::ranges::equal(opened.removed(), removed));
}

RC_GTEST_PROP(OpenedMap, IsAValue, ()) {
    const Map map((*random_map(80, 10)).grid());
    const std::vector<ObstacleId> removed = some_obstacles(map, 3);
    auto original = std::make_unique<OpenedMap>(map, removed);
    OpenedMap copy(map);
    copy = *original;
    // A copy shares the opened lines; it outlives the original.
    RC_ASSERT(copy.row(0) == original->row(0));
    original.reset();
    check_same_world(copy, plain(map, removed));
    check_same_world(OpenedMap(map), plain(map));  // and the map itself never changes
}

TEST(OpenedMap, SharesTheLinesThatDoNotChange) {
    const Map map = map_from_ascii(R"(
        ......
        .aa...
        .....b)");
    const OpenedMap opened(map, std::vector<ObstacleId>{map.obstacle_at({1, 1})});
    EXPECT_EQ(opened.row(0), map.grid().row(0));
    EXPECT_NE(opened.row(1), map.grid().row(1));
    EXPECT_EQ(opened.row(2), map.grid().row(2));
    EXPECT_EQ(opened.column(0), map.transposed().row(0));
    EXPECT_NE(opened.column(2), map.transposed().row(2));
    EXPECT_EQ(opened.column(5), map.transposed().row(5));
}

}  // namespace
}  // namespace waybreaker
