#include "render/name_places.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "worlds.hpp"

namespace waybreaker::render {
namespace {

constexpr double pixels = 10;
constexpr double clear = 12;
constexpr Rectangle room{0, 0, 400, 200};

// Where all of them begin: there is room for each.
std::vector<Point> begins_of(const std::vector<Name>& names, const std::vector<Mark>& others = {}) {
    std::vector<Point> begins;
    for (const std::optional<Point>& begin : name_places(names, others, pixels, room)) {
        EXPECT_TRUE(begin);
        begins.push_back(begin.value_or(Point{}));
    }
    return begins;
}

bool cover(const Name& a, Point at, const Name& b, Point other) {
    return at.x < other.x + b.width && other.x < at.x + a.width && std::abs(at.y - other.y) < pixels;
}

TEST(NamePlaces, StandToTheRightWhereThereIsRoom) {
    const std::vector<Point> begins = begins_of({{{100, 100}, "1", 8, clear}, {{300, 100}, "2", 8, clear}});
    EXPECT_EQ(begins[0].x, 112);
    EXPECT_EQ(begins[1].x, 312);
    EXPECT_NEAR(begins[0].y, 103.6, 1e-9);
}

TEST(NamePlaces, KeepOffEachOtherAndOffSigns) {
    // The second sign is where the first name would stand, the third below it.
    const std::vector<Name> names{
        {{100, 100}, "one", 24, clear}, {{124, 100}, "two", 24, clear}, {{112, 126}, "three", 40, clear}};
    const std::vector<Point> begins = begins_of(names);
    for (std::size_t i = 0; i < names.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(cover(names[i], begins[i], names[j], begins[j])) << i << j;
    }
    EXPECT_LT(begins[0].x, 100);
}

TEST(NamePlaces, KeepOffSignsWithoutNames) {
    const Name name{{100, 100}, "8.2", 30, clear};
    const std::vector<Mark> others{{{130, 100}, clear}, {{60, 100}, clear}};
    const Point begin = begins_of({name}, others).front();
    EXPECT_TRUE(begin.y < 92 || begin.y > 116) << begin.x << " " << begin.y;  // below or above the signs
}

TEST(NamePlaces, WithoutRoomAreLeftOut) {
    // A picture that has room for two lines, and three places in a row.
    const std::vector<Name> names{
        {{20, 12}, "first one", 30, 5}, {{24, 12}, "second one", 30, 5}, {{28, 12}, "third one", 30, 5}};
    const auto begins = name_places(names, {}, pixels, {0, 0, 60, 24});
    EXPECT_LT(std::ranges::count_if(begins, [](const auto& begin) { return begin.has_value(); }), 3);
    for (std::size_t i = 0; i < names.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            if (!begins[i] || !begins[j]) continue;
            EXPECT_FALSE(cover(names[i], *begins[i], names[j], *begins[j])) << i << j;
        }
    }
}

TEST(NamePlaces, StayInThePicture) {
    std::vector<Name> names;
    for (const Point at : {Point{395, 100}, Point{390, 110}, Point{5, 5}, Point{398, 198}, Point{200, 1}}) {
        names.push_back({at, "fire engine, drone", 110, clear});
    }
    const std::vector<Point> begins = begins_of(names);
    for (std::size_t i = 0; i < names.size(); ++i) {
        EXPECT_GE(begins[i].x, 0) << i;
        EXPECT_LE(begins[i].x + names[i].width, 400) << i;
        EXPECT_GE(begins[i].y, 8) << i;
        EXPECT_LE(begins[i].y, 200) << i;
        for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(cover(names[i], begins[i], names[j], begins[j])) << i << j;
    }
}

TEST(NamePlaces, OfManyAtOnePlaceTheFirstAreNamed) {
    const World world = wall();
    Mission mission = world.mission;
    mission.agents.clear();
    for (int i = 0; i < 30; ++i) {
        mission.agents.push_back({.id = "helicopter " + std::to_string(i), .kind = AgentKind::air});
    }
    const Layout layout = lay_out(world.map, {}, 6);
    const std::vector<Name> names = names_at_places(mission, layout);
    ASSERT_EQ(names.size(), 1U);
    EXPECT_TRUE(names[0].text.ends_with(", +27")) << names[0].text;
    EXPECT_LT(names[0].width, layout.width / 2);
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
