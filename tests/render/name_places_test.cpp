#include "render/name_places.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "worlds.hpp"

namespace waybreaker::render {
namespace {

constexpr double pixels = 10;
constexpr double clear = 12;

bool cover(const Name& a, Point at, const Name& b, Point other) {
    return at.x < other.x + b.width && other.x < at.x + a.width && std::abs(at.y - other.y) < pixels;
}

TEST(NamePlaces, StandToTheRightWhereThereIsRoom) {
    const std::vector<Point> begins = name_places({{{100, 100}, "1", 8, clear}, {{300, 100}, "2", 8, clear}}, pixels);
    EXPECT_EQ(begins[0].x, 112);
    EXPECT_EQ(begins[1].x, 312);
    EXPECT_NEAR(begins[0].y, 103.6, 1e-9);
}

TEST(NamePlaces, KeepOffEachOtherAndOffSigns) {
    // The second sign is where the first name would stand, the third below it.
    const std::vector<Name> names{
        {{100, 100}, "one", 24, clear}, {{124, 100}, "two", 24, clear}, {{112, 126}, "three", 40, clear}};
    const std::vector<Point> begins = name_places(names, pixels);
    for (std::size_t i = 0; i < names.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(cover(names[i], begins[i], names[j], begins[j])) << i << j;
    }
    EXPECT_LT(begins[0].x, 100);
}

TEST(NamePlaces, ThoseOfOnePlaceAreOneName) {
    const World world = wall();
    Mission mission = world.mission;
    mission.agents = {{.id = "1", .start = {0, 0}, .goal = {5, 5}},
                      {.id = "a<b", .start = {5, 5}, .goal = {0, 0}},
                      {.id = "air1", .kind = AgentKind::air, .start = {0, 0}, .goal = {0, 0}}};
    const std::vector<Name> names = names_at_places(mission, lay_out(world.map, {}, 6));
    ASSERT_EQ(names.size(), 2U);
    EXPECT_EQ(names[0].text, "1, a&lt;b, air1");
    EXPECT_EQ(names[1].text, "1, a&lt;b");
    EXPECT_GT(names[0].width, names[1].width);
    EXPECT_EQ(names[0].clear, names[1].clear);  // both are starts and goals, and have the wide ring
}

}  // namespace
}  // namespace waybreaker::render
