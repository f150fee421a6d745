#include "render/motion.hpp"

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

#include "picture_words.hpp"
#include "render/layout.hpp"
#include "worlds.hpp"

namespace waybreaker::render {
namespace {

// The wall of `worlds.hpp`, driven in 10 units of time: breached from 3 to 5, the vehicle waits in front of it.
World wall_in_time() {
    World world = wall();
    world.mission.rules.breach_time.per_obstacle = 2;
    world.plan.breaches[0].cleared_at = 5;
    world.plan.agents = {{"ground", AgentKind::ground, 1, {{0, 2, 0}, {3, 2, 3}, {3, 2, 5}, {7, 2, 9}}, {0, 2}, {7, 2}},
                         {"air", AgentKind::air, 1, {{0, 2, 0}, {3, 1, 3}, {3, 1, 5}, {7, 2, 10}}, {0, 2}, {7, 2}}};
    return world;
}

std::string moving_svg(const World& world) {
    return svg_of(world, {.width = 1000, .animate = true});
}

// What is between `#id{` ... of its keyframes: all between the braces.
std::string keyframes(const std::string& svg, const std::string& id) {
    const std::string begin = "@keyframes " + id + "{";
    const std::size_t from = svg.find(begin);
    if (from == std::string::npos) return "";
    return svg.substr(from + begin.size(), svg.find("}\n", from) - from - begin.size());
}

std::string at(const World& world, double percent, double x, double y) {
    const Layout layout = lay_out(world.map, {.width = 1000}, 0);
    std::ostringstream text;
    const Point place = layout.at(x, y);
    text << percent << "%{transform:translate(" << place.x << "px," << place.y << "px)}";
    return text.str();
}

TEST(Motion, IsNotThereUnlessAskedFor) {
    const std::string still = svg_of(wall_in_time());
    EXPECT_EQ(still.find("<style>"), std::string::npos);
    EXPECT_EQ(still.find("keyframes"), std::string::npos);
}

TEST(Motion, AddsToTheStillPictureAndChangesNothingOfIt) {
    const World world = wall_in_time();
    auto picture = parsed(moving_svg(world));
    for (const auto& found : picture.select_nodes("/svg/style | /svg/g[@class='motion']")) {
        picture.child("svg").remove_child(found.node());
    }
    std::ostringstream left, still;
    picture.save(left);
    parsed(svg_of(world, {.width = 1000})).save(still);
    EXPECT_EQ(left.str(), still.str());
}

TEST(Motion, TakesAgentsAlongTheirTimedPaths) {
    const World world = wall_in_time();
    const std::string svg = moving_svg(world);
    EXPECT_EQ(keyframes(svg, "agent1"), at(world, 0, 0, 2) + at(world, 27, 3, 2) + at(world, 45, 3, 2) +
                                            at(world, 81, 7, 2) + at(world, 100, 7, 2));
    EXPECT_EQ(keyframes(svg, "agent2"), at(world, 0, 0, 2) + at(world, 27, 3, 1) + at(world, 45, 3, 1) +
                                            at(world, 90, 7, 2) + at(world, 100, 7, 2));
}

TEST(Motion, LetsAnObstacleStandUntilItIsBreached) {
    const std::string svg = moving_svg(wall_in_time());
    EXPECT_EQ(keyframes(svg, "standing1"), "0%,45%{opacity:1}46.5%,100%{opacity:0}");
    EXPECT_EQ(keyframes(svg, "breach1"), "0%,26.9%{opacity:0}27%,45%{opacity:1}48%,100%{opacity:0}");
    const auto picture = parsed(svg);
    const auto standing = picture.select_node("/svg/g[@id='standing1']/path").node();
    EXPECT_STREQ(standing.attribute("d").value(), "m4 0h1v6h-1z") << "the wall, and not its neighbour";
    const auto other = picture.select_node("/svg/path[@fill='#dcd4c8']").node();
    EXPECT_STREQ(standing.attribute("fill").value(), other.attribute("fill").value()) << "looks as others do";
}

TEST(Motion, WithoutTimingRemovedObstaclesNeverStand) {
    World world = wall_in_time();
    world.mission.rules.timing = Timing::ignore;
    const std::string svg = moving_svg(world);
    EXPECT_EQ(svg.find("standing1"), std::string::npos);
    EXPECT_NE(svg.find("agent1"), std::string::npos);
}

TEST(Motion, DrawsObstaclesOfMapsTooLargeForThePicture) {
    std::vector<std::uint32_t> labels(2000 * 2000, 0);
    for (std::size_t y = 0; y < 2000; ++y) {
        labels[y * 2000 + 1000] = 1;
        labels[y * 2000 + 1500] = 2;
    }
    World world{Map::from_labels(2000, 2000, labels), ground_and_air({0, 0}, {1999, 0}), {}};
    world.plan.status = PlanStatus::solved;
    world.plan.breaches = {{.obstacle = {2}, .cells = 2000, .at = {1499, 0}, .cleared_at = 1499}};
    world.plan.agents = {{"ground", AgentKind::ground, 1, {{0, 0, 0}, {1999, 0, 1999}}, {0, 0}, {1999, 0}},
                         {"air", AgentKind::air, 1, {{0, 0, 0}, {1999, 0, 1999}}, {0, 0}, {1999, 0}}};
    const int step = lay_out(world.map, {.width = 300}, 0).sample_step;
    ASSERT_GT(step, 1);
    const auto picture = parsed(svg_of(world, {.width = 300, .animate = true}));
    const std::string left = "m" + std::to_string(1500 / step) + " 0h1v";
    EXPECT_EQ(std::string(picture.select_node("//g[@id='standing1']/path").node().attribute("d").value())
                  .substr(0, left.size()),
              left);
    EXPECT_FALSE(picture.select_node("//g[@id='standing2']"));
}

TEST(Motion, IsOnlyForThoseWhoHaveNotAskedForLess) {
    const std::string svg = moving_svg(wall_in_time());
    const std::size_t query = svg.find("@media (prefers-reduced-motion:no-preference){");
    ASSERT_NE(query, std::string::npos);
    EXPECT_LT(svg.find(".motion{visibility:hidden}"), query);
    EXPECT_GT(svg.find("@keyframes"), query);
    EXPECT_GT(svg.find("animation:"), query);
}

TEST(Motion, OfNoPlanIsNone) {
    const World world = unsolved(map_from_ascii(wall_picture), {0, 2}, {7, 2});
    EXPECT_EQ(moving_svg(world), svg_of(world, {.width = 1000}));
}

TEST(Motion, OfATeamGivesEachItsColour) {
    World world = wall_in_time();
    Agent second = world.mission.agents[0];
    second.id = "second";
    world.mission.agents.push_back(second);
    world.plan.agents.push_back({"second", AgentKind::ground, 1, {{0, 4, 0}, {0, 6, 2}}, {0, 4}, {0, 6}});
    world.plan.breaches[0].by = "air";
    world.plan.breaches[0].begun_at = 4;
    const std::string svg = moving_svg(world);
    const auto picture = parsed(svg);
    const auto colour = [&](const char* id) {
        const std::string query = "//g[@id='" + std::string(id) + "']/circle";
        return std::string(picture.select_node(query.c_str()).node().attribute("fill").value());
    };
    EXPECT_EQ(colour("agent1"), "#0072b2");
    EXPECT_EQ(colour("agent3"), "#d41972");
    EXPECT_EQ(colour("agent2"), "#e69f00");
    EXPECT_NE(keyframes(svg, "breach1").find("36%,45%{opacity:1}"), std::string::npos) << "as long as the plan says";
}

}  // namespace
}  // namespace waybreaker::render
