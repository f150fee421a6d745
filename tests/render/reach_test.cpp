// Pictures of many places: bands of time, what is gained, places as dots.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>

#include "picture_words.hpp"
#include "render/palette.hpp"
#include "render/reach_json.hpp"
#include "worlds.hpp"

namespace waybreaker::render {
namespace {

constexpr float no_way = std::numeric_limits<float>::infinity();

// A hub at the left of a wall and three places; the plan opens the wall.
struct Opened {
    World world = {map_from_ascii("S.a....."), {}, {}};
    PictureOptions options = {.objective = Objective::flowtime};

    Opened() {
        world.mission.rules.collisions = false;
        world.mission.rules.unreached = 20;
        world.plan.status = PlanStatus::solved;
        world.plan.breaches = {{.obstacle = {1}, .cells = 1, .at = {1, 0}, .cleared_at = 3, .by = "air"}};
        const auto add = [&](const Agent& agent, bool reached) {
            world.mission.agents.push_back(agent);
            world.plan.agents.push_back({.id = agent.id,
                                         .kind = agent.kind,
                                         .path = {{0, 0, 0}, {double(agent.goal.x), 0, 5}},
                                         .start = agent.start,
                                         .goal = agent.goal,
                                         .reached = reached});
        };
        for (const int x : {1, 4, 6, 7}) add(vehicle("to " + std::to_string(x), {0, 0}, {x, 0}), x != 7);
        add(aircraft("air", {0, 0}), true);
        options.reach = Reach{.hubs = {{0, 0}},
                              .before = {0, 1, no_way, no_way, 12, 13, no_way, no_way},
                              .after = {0, 1, 4, 5, 6, 7, 8, 30}};
    }
    pugi::xml_document picture() const { return parsed(svg_of(world, options)); }
};

std::size_t areas(const pugi::xml_document& picture, std::string_view fill) {
    const std::string query = "/svg/path[@fill='" + std::string(fill) + "']";
    return picture.select_nodes(query.c_str()).size();
}

TEST(PictureOfPlaces, ShowsBandsAndWhatIsGained) {
    const auto picture = Opened().picture();
    // 13 units of time in six bands of 2.5.
    for (const char* words :
         {"reached by 2.5", "reached by 5", "reached by 15", "not reached", "0.25 or more sooner", "reached only now",
          "1 place", "1 place sooner", "1 place only now", "1 place not reached"}) {
        EXPECT_TRUE(says(picture, words)) << words;
    }
    EXPECT_EQ(areas(picture, colour::bands[0]), 1U);
    EXPECT_EQ(areas(picture, colour::bands[3]), 1U);
    EXPECT_EQ(areas(picture, colour::bands[4]), 0U) << "no ground is reached between 10 and 12.5";
    EXPECT_EQ(areas(picture, "url(#sooner)"), 1U);
    EXPECT_EQ(areas(picture, "url(#onlynow)"), 1U);
    EXPECT_EQ(areas(picture, "url(#unreached)"), 1U);
    EXPECT_EQ(picture.select_nodes("//pattern[@id='sooner']").size(), 1U);
}

TEST(PictureOfPlaces, SaysNothingOfWhatThereIsNot) {
    Opened opened;
    opened.options.reach->before = opened.options.reach->after = {0, 1, 4, 5, 6, 7, 8, 9};
    for (Itinerary& agent : opened.world.plan.agents) agent.reached = true;
    const auto picture = opened.picture();
    for (const char* words : {"not reached", "reached only now", "1 place not reached"})
        EXPECT_FALSE(says(picture, words)) << words;
    EXPECT_TRUE(says(picture, "4 places"));
    EXPECT_EQ(areas(picture, "url(#sooner)"), 0U);
}

// As the page has them.
nlohmann::json document(const Opened& opened, io::MapFile map) {
    io::PlanFile plan;
    plan.asked.mission = opened.world.mission;
    plan.plan = opened.world.plan;
    return nlohmann::json::parse(reach_json(map, plan, opened.options.reach));
}

std::vector<int> cells_of(const nlohmann::json& runs) {
    std::vector<int> cells;
    for (std::size_t i = 0; i < runs.size(); i += 2) cells.insert(cells.end(), runs[i + 1].get<std::size_t>(), runs[i]);
    return cells;
}

TEST(ReachAsData, HasTheBandsOfThePicture) {
    const Opened opened;
    const auto json = document(opened, {.map = opened.world.map});
    EXPECT_EQ(json["format"], "waybreaker-reach/1");
    EXPECT_EQ(json["hubs"], nlohmann::json::parse("[[0, 0]]"));
    EXPECT_EQ(json["inbound"], false);
    EXPECT_EQ(json["bands"], nlohmann::json::parse("[2.5, 5, 7.5, 10, 12.5, 15]"));
    EXPECT_EQ(json["sooner"], 0.25);
    EXPECT_EQ(cells_of(json["before"]), (std::vector{1, 1, 0, 7, 5, 6, 7, 7}));
    EXPECT_EQ(cells_of(json["after"]), (std::vector{1, 1, 2, 3, 3, 3, 4, 7}));
    EXPECT_EQ(cells_of(json["gains"]), (std::vector{0, 0, 0, 2, 1, 1, 2, 0}));
    EXPECT_EQ(json["after"][2], 2) << "runs are as long as can be";
}

TEST(ReachAsData, IsInUnitsOfTimeWhereThePictureShowsSeconds) {
    // All speeds are 1: a unit of time is what a metre a second takes for a cell, here two seconds.
    const Opened opened;
    const auto json = document(opened, {.map = opened.world.map, .cell_size = 2});
    EXPECT_EQ(json["bands"], nlohmann::json::parse("[2.5, 5, 7.5, 10, 12.5, 15]"));
}

TEST(ReachAsData, HasNoBandsWithoutReach) {
    Opened opened;
    opened.options.reach.reset();
    EXPECT_EQ(document(opened, {.map = opened.world.map}),
              nlohmann::json::parse(R"({"format": "waybreaker-reach/1", "width": 8, "height": 1, "bands": []})"));
}

TEST(PictureOfPlaces, IsThatOfATeamWithoutReach) {
    Opened opened;
    opened.options.reach.reset();
    const auto picture = opened.picture();
    EXPECT_FALSE(says(picture, "not reached"));
    EXPECT_EQ(picture.select_nodes("//pattern[@id='sooner']").size(), 0U);
}

TEST(PictureOfPlaces, BigMapsAreDrawnCoarser) {
    Opened opened;
    const int width = 2400;
    opened.world.map = Map(Grid(width, 4));
    opened.world.plan.breaches.clear();
    Reach& reach = *opened.options.reach;
    reach.before.assign(std::size_t(width) * 4, no_way);
    for (std::size_t i = 0; i < reach.before.size(); ++i) reach.before[i] = float(i % std::size_t(width)) / 200;
    reach.after = reach.before;
    opened.options.width = 400;
    const auto picture = opened.picture();
    for (const std::string_view band : colour::bands) EXPECT_EQ(areas(picture, band), 1U);
}

// Lightness in Oklab of a colour "#rrggbb".
double lightness(std::string_view colour) {
    const auto part = [&](std::size_t at) {
        const double value = double(std::stoi(std::string(colour.substr(at, 2)), nullptr, 16)) / 255;
        return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
    };
    const double r = part(1);
    const double g = part(3);
    const double b = part(5);
    return 0.2104542553 * std::cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b) +
           0.7936177850 * std::cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b) -
           0.0040720468 * std::cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
}

TEST(PictureOfPlaces, BandsPrintInGrey) {
    for (std::size_t i = 1; i < colour::bands.size(); ++i)
        EXPECT_GE(lightness(colour::bands[i]) - lightness(colour::bands[i - 1]), 0.07);
    EXPECT_GE(lightness(colour::street) - lightness(colour::bands.back()), 0.04);
}

}  // namespace
}  // namespace waybreaker::render
