// Names, notes and signs in pictures: inside, apart from each other, and explained.
#include <gtest/gtest.h>

#include <algorithm>
#include <pugixml.hpp>

#include "picture_words.hpp"
#include "worlds.hpp"

namespace waybreaker::render {
namespace {

using namespace std::string_literals;

// The texts that reach over the picture's sides, if each letter is as wide as most are or less.
std::vector<std::string> cut_off(const pugi::xml_document& picture) {
    const double width = picture.child("svg").attribute("width").as_double();
    std::vector<std::string> found;
    for (const auto& one : picture.select_nodes("//text")) {
        const pugi::xml_node node = one.node();
        const std::string text = node.text().get();
        const double extent = 0.6 * node.attribute("font-size").as_double() * double(text.size());
        const std::string_view anchor = node.attribute("text-anchor").as_string("start");
        const double x = node.attribute("x").as_double();
        const double begin = anchor == "end" ? x - extent : anchor == "middle" ? x - extent / 2 : x;
        if (begin < 0 || begin + extent > width) found.push_back(text);
    }
    return found;
}

TEST(Picture, NoLabelIsCutOff) {
    World world = wall();
    world.plan.breaches[0].at = {7, 0};
    world.plan.breaches[0].cleared_at = 123456.5;
    EXPECT_EQ(cut_off(parsed(svg_of(world))), std::vector<std::string>());

    world.mission.agents[0].id = "fire engine";
    world.mission.agents[1].id = "helicopter";
    world.mission.agents.push_back({.id = "drone", .kind = AgentKind::air, .start = {7, 2}, .goal = {7, 2}});
    world.plan.breaches[0].by = "helicopter";
    for (const Agent& agent : world.mission.agents) {
        world.plan.agents.push_back({.id = agent.id, .kind = agent.kind, .path = {{0, 2, 0}, {7, 2, 7}}});
    }
    const auto team = parsed(svg_of(world));
    EXPECT_TRUE(says(team, "fire engine, helicopter, drone"));
    EXPECT_TRUE(says(team, "123456 helicopter"));
    EXPECT_EQ(cut_off(team), std::vector<std::string>());
}

TEST(Picture, WhatWasToBeSmallComesFirstAndIsBold) {
    World world = wall();
    world.plan.before.ground_makespan = 11.5;
    world.plan.after.ground_makespan = 7;
    const auto bold = [](const pugi::xml_document& picture) {
        const auto found = picture.select_nodes("//text[@font-weight and not(@text-anchor)]");
        return std::string(found[found.size() - 1].node().text().get());
    };
    for (const auto& [objective, name] : {std::pair{Objective::makespan, "makespan"s},
                                          {Objective::flowtime, "flowtime"s},
                                          {Objective::ground_makespan, "ground arrival"s}}) {
        const auto single = parsed(svg_of(world, {.objective = objective}));
        const std::vector<std::string> all = words(single);
        const auto row = std::ranges::find(all, name);
        ASSERT_NE(row, all.end());
        EXPECT_LE(row - all.begin(), std::ranges::find(all, "makespan") - all.begin());
        EXPECT_LE(row - all.begin(), std::ranges::find(all, "flowtime") - all.begin());
        EXPECT_EQ(bold(single), name);
    }
    EXPECT_TRUE(says(parsed(svg_of(world, {.objective = Objective::flowtime})),
                     "Flowtime 18.5 → 14.2 cells at speed 1 (−23.2 %), 1 obstacle removed"));

    world.mission.agents.push_back({.id = "2", .start = {0, 0}, .goal = {0, 6}});
    const std::string begin = "3 agents: flowtime 14.2 cells at speed 1, ";
    const auto team = parsed(svg_of(world, {.objective = Objective::flowtime}));
    EXPECT_TRUE(std::ranges::any_of(words(team), [&](const std::string& text) { return text.starts_with(begin); }));
    EXPECT_EQ(bold(team), "flowtime");

    world.plan.bound = 14.2 / 1.5;
    const std::string end = ", gap 50.0 %";
    const auto bounded = words(parsed(svg_of(world, {.objective = Objective::flowtime})));
    EXPECT_TRUE(std::ranges::any_of(bounded, [&](const std::string& text) { return text.ends_with(end); }));
}

TEST(Picture, ShowsBasesWhereAircraftRecharge) {
    World world = wall();
    Agent& air = world.mission.agents[1];
    air.bases = {{5, 5}, {1, 6}, {5, 5}};
    EXPECT_FALSE(says(parsed(svg_of(world)), "recharging base")) << "nobody recharges";
    const auto rectangles = [](const pugi::xml_document& picture) { return picture.select_nodes("/svg/rect").size(); };
    const std::size_t without = rectangles(parsed(svg_of(world)));
    air.recharge = 2;
    const auto picture = parsed(svg_of(world));
    EXPECT_TRUE(says(picture, "recharging base"));
    EXPECT_EQ(rectangles(picture), without + 10) << "each base once: a plate, its edge and a battery of three";
}

}  // namespace
}  // namespace waybreaker::render
