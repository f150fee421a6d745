// Map::boundary, the cells an obstacle can be breached from.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "ascii_map.hpp"
#include "flight/brute_force.hpp"

namespace waybreaker {
namespace {

RC_GTEST_PROP(Boundary, IsWhatItsDefinitionSays, ()) {
    // Widths around the word size, where bits cross from word to word.
    const int width = *uniform(1, 140);
    const int height = *uniform(1, 8);
    const World world = *arbitrary_world(width, height, *uniform(1, 8), *rc::gen::elementOf(std::vector{3, 80}));
    for (const ObstacleId id : world.ids) RC_ASSERT(world.map.boundary(id) == slow_boundary(world.map, id));
}

TEST(Boundary, HoldsHolesAndOtherObstacles) {
    const Map map = map_from_ascii(R"(
        aaab.
        a.ab.
        aaa..)");
    const std::vector<Cell> expected{{3, 0}, {1, 1}, {3, 1}, {3, 2}};
    EXPECT_EQ(map.boundary(map.obstacle_at({0, 0})), expected);
}

TEST(Boundary, OfAnObstacleThatFillsTheMapIsEmpty) {
    EXPECT_TRUE(map_from_ascii("##\n##").boundary({1}).empty());
}

}  // namespace
}  // namespace waybreaker
