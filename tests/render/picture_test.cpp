#include "render/picture.hpp"

#include <gtest/gtest.h>

#include <pugixml.hpp>
#include <random>

#include "picture_words.hpp"
#include "render/layout.hpp"
#include "waybreaker/error.hpp"
#include "worlds.hpp"

namespace waybreaker::render {
namespace {

using namespace std::string_literals;

std::size_t count(const pugi::xml_document& picture, const std::string& query) {
    return picture.select_nodes(query.c_str()).size();
}

TEST(Picture, ShowsTheFigures) {
    const auto picture = parsed(svg_of(wall(), {.annotations = {.title = "The wall", .attribution = "By hand"}}));
    EXPECT_TRUE(says(picture, "The wall"));
    EXPECT_TRUE(says(picture, "Makespan 11.5 → 7.2 cells at speed 1 (−37.4 %), 1 obstacle removed"));
    EXPECT_TRUE(says(picture, "8 × 7 cells"));
    EXPECT_TRUE(says(picture, "By hand"));
    for (const char* figure : {"11.5", "7.0", "−39.1 %", "7.2", "+2.9 %", "18.5", "14.2", "−23.2 %"}) {
        EXPECT_TRUE(says(picture, figure)) << figure;
    }
}

TEST(Picture, ScalesLengthsToMetres) {
    const auto picture = parsed(svg_of(wall(), {.cell_size = 2.5, .metres = true}));
    EXPECT_TRUE(says(picture, "Makespan 28.8 → 18.0 s at 1 m/s (−37.4 %), 1 obstacle removed, 37.5 m²"));
    EXPECT_TRUE(says(picture, "length in metres"));
    EXPECT_TRUE(says(picture, "time in s at 1 m/s"));
    EXPECT_TRUE(says(picture, "2 m")) << "the scale bar";
}

TEST(Picture, CallsSectionsOpenings) {
    const site::Sections sections{{{site::ObstacleKind::building, 7, "Mill"}, {site::ObstacleKind::barrier, 8, ""}},
                                  {{}, {0, 1}}};
    const auto picture = parsed(svg_of(wall(), {.annotations = {.sections = sections}}));
    EXPECT_TRUE(says(picture, "Makespan 11.5 → 7.2 cells at speed 1 (−37.4 %), 1 opening"));
}

TEST(Picture, DoesNotCallTimesLengths) {
    World world = wall();
    world.mission.agents[1].speed = 2;
    const auto picture = parsed(svg_of(world, {.cell_size = 10, .metres = true}));
    EXPECT_TRUE(says(picture, "Makespan 11.5 → 7.2 units of time (−37.4 %), 1 obstacle removed, 600 m²"));
    EXPECT_TRUE(says(picture, "115.0")) << "path A";
    // Rows of length stand under their unit, rows of time under theirs.
    const auto all = words(picture);
    const auto place = [&](const char* word) { return std::find(all.begin(), all.end(), word) - all.begin(); };
    EXPECT_LT(place("length in metres"), place("path A, ground"));
    EXPECT_LT(place("path B, air"), place("time in units of time"));
    EXPECT_LT(place("time in units of time"), place("makespan"));
    EXPECT_LT(place("flowtime"), std::ptrdiff_t(all.size()));
}

TEST(Picture, MarksTheRemovedObstacle) {
    const auto picture = parsed(svg_of(wall()));
    const auto hatched = picture.select_nodes("/svg/path[@fill='url(#hatching)']");
    ASSERT_EQ(hatched.size(), 1U);
    EXPECT_STREQ(hatched[0].node().attribute("d").value(), "m4 0h1v6h-1z");
    EXPECT_TRUE(says(picture, "1"));
    EXPECT_TRUE(says(picture, "removed obstacle"));
    EXPECT_TRUE(says(picture, "ground path before"));
}

TEST(Picture, ShowsWhenObstaclesAreBreachedAndHowLongTheGroundAgentWaits) {
    World world = wall();
    world.plan.breaches[0].cleared_at = 4.25;
    const auto without_waits = parsed(svg_of(world));
    EXPECT_TRUE(says(without_waits, "breach, when"));
    EXPECT_TRUE(says(without_waits, "4.2"));
    EXPECT_FALSE(says(without_waits, "wait, how long"));
    world.plan.agents = {{"ground", AgentKind::ground, 1, {{0, 2, 0}, {0, 2, 0.75}, {7, 2, 7.75}}, {0, 2}, {7, 2}},
                         {"air", AgentKind::air, 1, {{0, 2, 0}, {3, 1, 3.25}, {3, 1, 4.25}}, {0, 2}, {7, 2}}};
    const auto in_metres = parsed(svg_of(world, {.cell_size = 10, .metres = true}));
    EXPECT_TRUE(says(in_metres, "42.5"));
    EXPECT_TRUE(says(in_metres, "+7.5")) << "one wait, of the ground agent";
    EXPECT_FALSE(says(in_metres, "+10.0")) << "the air agent's stay is none";
    EXPECT_TRUE(says(in_metres, "wait, how long"));
}

TEST(Picture, ShowsTheGapToTheBestPossible) {
    World world = wall();
    world.plan.bound = 6;
    EXPECT_TRUE(
        says(parsed(svg_of(world)), "Makespan 11.5 → 7.2 cells at speed 1 (−37.4 %), 1 obstacle removed, gap 20.0 %"));
    world.plan.bound = 14.2 / 1.5;
    EXPECT_TRUE(says(parsed(svg_of(world, {.objective = Objective::flowtime})),
                     "Flowtime 18.5 → 14.2 cells at speed 1 (−23.2 %), 1 obstacle removed, gap 50.0 %"));
}

TEST(Picture, WithoutRemovalsHasNoBefore) {
    World world = wall();
    world.plan.after = world.plan.before;
    world.plan.breaches.clear();
    const auto picture = parsed(svg_of(world));
    EXPECT_TRUE(says(picture, "Makespan 11.5 cells at speed 1, no obstacle removed"));
    for (const char* entry : {"removed obstacle", "breach, when", "ground path before", "air path before"}) {
        EXPECT_FALSE(says(picture, entry)) << entry;
    }
    EXPECT_EQ(count(picture, "/svg/path[@fill='url(#hatching)']"), 0U);
}

TEST(Picture, DistinguishesFixedObstacles) {
    std::vector<ObstacleAttributes> attributes(2);
    attributes[1].destructible = false;
    const World world = unsolved(Map::from_labels(3, 1, {0, 1, 0}, attributes), {0, 0}, {2, 0});
    const auto picture = parsed(svg_of(world));
    EXPECT_TRUE(says(picture, "not removable"));
    EXPECT_FALSE(says(picture, "obstacle"));
}

TEST(Picture, TellsApartWhatTheGroundIs) {
    std::vector<ObstacleAttributes> attributes(7);
    for (const std::size_t fixed : {1U, 2U, 3U, 4U}) attributes[fixed].destructible = false;
    const World world = unsolved(Map::from_labels(8, 1, {0, 1, 2, 3, 4, 5, 6, 0}, attributes), {0, 0}, {7, 0});
    using enum site::ObstacleKind;
    const auto picture = parsed(
        svg_of(world, {.annotations = {.kinds = {unknown, water, cliff, forbidden, building, barrier, building}}}));
    const auto drawn = [&](const std::string& fill, const std::string& path) {
        return count(picture, "/svg/path[@fill='" + fill + "'][@d='" + path + "']");
    };
    EXPECT_EQ(drawn("url(#waves)", "m1 0h1v1h-1z"), 1U);
    EXPECT_EQ(drawn("#776d62", "m2 0h1v1h-1z"), 1U);
    EXPECT_EQ(drawn("url(#stripes)", "m3 0h1v1h-1z"), 1U);
    EXPECT_EQ(drawn("#a89f93", "m4 0h1v1h-1z"), 1U);
    EXPECT_EQ(drawn("#a8885f", "m5 0h1v1h-1z"), 1U);
    EXPECT_EQ(drawn("#dcd4c8", "m6 0h1v1h-1z"), 1U);
    for (const char* entry :
         {"water", "cliff or ditch", "forbidden ground", "not removable", "wall, fence, hedge", "obstacle"}) {
        EXPECT_TRUE(says(picture, entry)) << entry;
    }
}

TEST(Picture, HasDotsOffTheRoads) {
    std::vector<ObstacleAttributes> attributes(2);
    attributes[1].destructible = false;
    const World world = unsolved(Map::from_labels(3, 1, {0, 1, 0}, attributes), {0, 0}, {2, 0});
    const auto picture =
        parsed(svg_of(world, {.annotations = {.kinds = {site::ObstacleKind::unknown, site::ObstacleKind::off_road}}}));
    EXPECT_EQ(count(picture, "/svg/path[@fill='url(#dots)'][@d='m1 0h1v1h-1z']"), 1U);
    EXPECT_TRUE(says(picture, "off the roads"));
    EXPECT_FALSE(says(picture, "forbidden ground"));
}

TEST(Picture, ShowsWhatNobodyKnows) {
    std::vector<ObstacleAttributes> attributes(3);
    attributes[1].destructible = attributes[2].destructible = false;
    const World world = unsolved(Map::from_labels(4, 1, {0, 1, 2, 0}, attributes), {0, 0}, {3, 0});
    const auto picture = parsed(svg_of(world, {.annotations = {.tags = {{"occupancy=unknown", {{1}}}}}}));
    EXPECT_EQ(count(picture, "/svg/path[@fill='url(#lattice)'][@d='m1 0h1v1h-1z']"), 1U);
    EXPECT_EQ(count(picture, "/svg/defs/pattern[@id='lattice']"), 1U);
    EXPECT_TRUE(says(picture, "unknown: no data"));
    EXPECT_TRUE(says(picture, "not removable"));
    EXPECT_FALSE(says(parsed(svg_of(world)), "unknown: no data"));
}

// Of any bytes, in lines that fit, and as tall as they need.
TEST(Picture, HasTheNotesOfItsMap) {
    const auto height = [](const auto& picture) { return picture.child("svg").attribute("height").as_double(); };
    const auto plain = parsed(svg_of(wall()));
    const auto noted =
        parsed(svg_of(wall(), {.annotations = {.notes = {"a <coast> ends", std::string(150, 'x') + " y"}}}));
    EXPECT_TRUE(says(noted, "A <coast> ends."));
    EXPECT_TRUE(says(noted, "y."));
    EXPECT_GT(height(noted), height(plain) + 60);
    std::string long_note;
    for (int i = 0; i < 1000; ++i) long_note += "word ";
    const auto cut = parsed(svg_of(wall(), {.annotations = {.notes = {long_note}}}));
    EXPECT_LT(height(cut), height(plain) + 140);
    EXPECT_TRUE(std::ranges::any_of(words(cut), [](const std::string& line) { return line.ends_with("word \u2026"); }));
}

TEST(Picture, HasALegendOfWhatIsThere) {
    World world = wall();
    world.map = map_from_ascii("....a...\n....a...\nS...a..G\n....a...\n....a...\n....a...\n........");  // and it goes
    EXPECT_FALSE(says(parsed(svg_of(world)), "obstacle"));
    world.plan.breaches.clear();
    const auto picture = parsed(svg_of(world));
    EXPECT_TRUE(says(picture, "obstacle"));
    for (const char* entry : {"water", "cliff or ditch", "forbidden ground", "not removable", "wall, fence, hedge"}) {
        EXPECT_FALSE(says(picture, entry)) << entry;
    }
}

TEST(Picture, HasRoomForALongLegend) {
    World world = wall();
    const auto lowest_and_height = [&](const PictureOptions& options) {
        const auto picture = parsed(svg_of(world, options));
        double lowest = 0;
        for (const auto& found : picture.select_nodes("//text")) {
            lowest = std::max(lowest, found.node().attribute("y").as_double());
        }
        return std::pair(lowest, picture.child("svg").attribute("height").as_double());
    };
    const auto [usual, height] = lowest_and_height({});
    world.plan.agents = {{"ground", AgentKind::ground, 1, {{0, 2, 0}, {0, 2, 1}, {7, 2, 8}}, {0, 2}, {7, 2}}};  // waits
    const Map& map = world.map;
    std::vector<std::uint32_t> labels(map.labels().begin(), map.labels().end());
    for (std::uint32_t i = 0; i < 6; ++i) labels[i] = i + 2;
    std::vector<ObstacleAttributes> attributes(8);
    for (const std::size_t fixed : {2U, 3U, 4U, 5U}) attributes[fixed].destructible = false;
    world.map = Map::from_labels(map.width(), map.height(), labels, attributes);
    using enum site::ObstacleKind;
    const auto [last, higher] = lowest_and_height(
        {.annotations = {.kinds = {unknown, building, water, cliff, forbidden, building, barrier, building}}});
    EXPECT_GT(higher, height + 29);
    EXPECT_LT(last, higher);
    EXPECT_DOUBLE_EQ(height - usual, higher - last) << "the attribution, below the legend";
}

TEST(Picture, TellsWaterFromTheRest) {
    std::vector<ObstacleAttributes> attributes(3);
    attributes[1].destructible = false;
    const World world = unsolved(Map::from_labels(5, 1, {0, 1, 2, 2, 0}, attributes), {0, 0}, {4, 0});
    using enum site::ObstacleKind;
    const auto picture = parsed(svg_of(world, {.annotations = {.kinds = {unknown, water, building}}}));
    EXPECT_TRUE(says(picture, "water"));
    EXPECT_TRUE(says(picture, "obstacle"));
    EXPECT_FALSE(says(picture, "not removable"));
}

TEST(Picture, SaysThatThereIsNoPlan) {
    World world = unsolved(map_from_ascii("S#G"), {0, 0}, {2, 0});
    const auto picture = parsed(svg_of(world));
    EXPECT_TRUE(says(picture, "No plan: the ground agent cannot reach its goal, no obstacle removed"));
    EXPECT_TRUE(says(picture, "start"));
    EXPECT_TRUE(says(picture, "goal"));
    EXPECT_FALSE(says(picture, "ground path"));
    world.plan.status = PlanStatus::limit_reached;
    EXPECT_TRUE(says(parsed(svg_of(world)), "No plan: the search reached its limit, no obstacle removed"));
    world.plan.status = PlanStatus::stopped;
    EXPECT_TRUE(says(parsed(svg_of(world)), "No plan: the search was stopped, no obstacle removed"));
}

TEST(Picture, SaysThatRemovalOpenedTheWay) {
    World world = wall();
    world.plan.before.ground() = {};
    world.plan.before.makespan.reset();
    world.plan.before.flowtime.reset();
    EXPECT_TRUE(says(parsed(svg_of(world)), "Makespan (no way) → 7.2 cells at speed 1, 1 obstacle removed"));
}

TEST(Picture, SurvivesHostileNames) {
    const std::string hostile = "</title><script>alert('&')</script>\x01\xFF\"";
    const auto picture = parsed(svg_of(wall(), {.annotations = {.title = hostile, .attribution = hostile}}));
    EXPECT_EQ(count(picture, "//script"), 0U);
    EXPECT_STREQ(picture.child("svg").child("title").text().get(), "</title><script>alert('&')</script>\uFFFD\uFFFD\"");
    EXPECT_LT(svg_of(wall(), {.annotations = {.title = std::string(1 << 20, '<')}}).size(), 20'000U);
}

TEST(Picture, RefusesSizesOutOfRange) {
    EXPECT_THROW(svg_of(wall(), {.width = least_width - 1}), InputError);
    EXPECT_THROW(svg_of(wall(), {.width = most_width + 1}), InputError);
    EXPECT_THROW(svg_of(wall(), {.cell_size = 0}), InputError);
    EXPECT_THROW(svg_of(wall(), {.cell_size = std::nan("")}), InputError);
    EXPECT_NO_THROW(svg_of(wall(), {.width = most_width}));
}

// Every size is a share of the width: what is legible at one size is at every other.
TEST(Picture, ScalesWithItsWidth) {
    const auto small = parsed(svg_of(wall(), {.width = 600}));
    const auto large = parsed(svg_of(wall(), {.width = 1800}));
    for (const char* query :
         {"//circle/@cx", "//circle/@cy", "//circle/@r", "//text/@x", "//text/@font-size", "/svg/rect/@width"}) {
        const auto a = small.select_nodes(query);
        const auto b = large.select_nodes(query);
        ASSERT_EQ(a.size(), b.size());
        ASSERT_FALSE(a.empty());
        for (std::size_t i = 0; i < a.size(); ++i) {
            EXPECT_NEAR(b[i].attribute().as_double(), 3 * a[i].attribute().as_double(), 0.02) << query;
        }
    }
    EXPECT_GE(600 * 14.5 / 1000, 8.5) << "pixels of the smallest text";
}

// Whatever the map's shape: all words lie on the picture, none but the breaches' numbers and times (which have a halo)
// on the map.
TEST(Picture, LegendAndCaptionCoverNothing) {
    std::vector<World> worlds;
    worlds.push_back(wall());
    for (const auto& [width, height] :
         {std::pair(1, 1), {1, 900}, {900, 1}, {16384, 3}, {3, 16384}, {40, 1000}, {512, 512}}) {
        worlds.push_back(unsolved(Map(Grid(width, height)), {0, 0}, {width - 1, height - 1}));
    }
    for (const World& world : worlds) {
        const PictureOptions options = {.annotations = {.title = "t", .attribution = "a"}};
        const Layout layout = lay_out(world.map, options, 6);
        const auto picture = parsed(svg_of(world, options));
        EXPECT_LE(layout.height, 2 * layout.width);
        for (const auto& found : picture.select_nodes("/svg/text[not(@text-anchor='middle') and not(@paint-order)]")) {
            const double x = found.node().attribute("x").as_double();
            const double y = found.node().attribute("y").as_double();
            const double size = found.node().attribute("font-size").as_double();
            EXPECT_TRUE(x >= 0 && x <= layout.width && y - size >= 0 && y <= layout.height);
            EXPECT_TRUE(y <= layout.window.y || y - size >= layout.window.y + layout.window.height)
                << found.node().text().get();
        }
    }
}

TEST(Picture, LabelsOfCloseBreachesLieApart) {
    const std::vector<Point> points = {{500, 500}, {503, 500}, {500, 506}, {2, 2}, {3, 3}};
    const std::vector<Point> goal = {{504, 496}};
    const Rectangle window = {0, 0, 1000, 1000};
    const auto labels = spread_labels(points, goal, 11, window);
    ASSERT_EQ(labels.size(), points.size());
    for (std::size_t i = 0; i < labels.size(); ++i) {
        EXPECT_LT(std::hypot(labels[i].x - points[i].x, labels[i].y - points[i].y), 8 * 11);
        EXPECT_GT(std::hypot(labels[i].x - goal[0].x, labels[i].y - goal[0].y), 2 * 11);
        EXPECT_TRUE(labels[i].x >= 0 && labels[i].y >= 0);
        for (std::size_t j = 0; j < i; ++j) {
            EXPECT_GT(std::hypot(labels[i].x - labels[j].x, labels[i].y - labels[j].y), 2 * 11);
        }
    }
    EXPECT_EQ(labels[3].x, 2) << "a label without neighbours lies on its point";
}

TEST(Picture, StartsAndGoalsThatDifferAreAllShown) {
    World world = wall();
    const std::size_t shared = count(parsed(svg_of(world)), "/svg/circle");
    world.mission.agents[1].start = {0, 6};
    EXPECT_EQ(count(parsed(svg_of(world)), "/svg/circle"), shared + 2) << "a start is two discs";
}

TEST(Picture, AStartThatIsTheGoalIsARingAroundIt) {
    const auto radius_of_start = [](Cell goal) {
        const auto picture = parsed(svg_of(unsolved(Map(Grid(9, 9)), {4, 4}, goal)));
        return picture.select_node("/svg/circle").node().attribute("r").as_double();
    };
    EXPECT_GT(radius_of_start({4, 4}), 1.5 * radius_of_start({8, 8}));
}

TEST(Picture, SaysWhichOfSeveralAircraftOpensWhat) {
    World world = wall();
    world.mission.agents.push_back({.id = "heli", .kind = AgentKind::air, .start = {0, 6}, .goal = {7, 6}});
    world.plan.breaches[0].by = "heli";
    for (Outcome* const outcome : {&world.plan.before, &world.plan.after}) {
        outcome->routes.push_back({.kind = AgentKind::air, .length = 7, .path = {{0, 6}, {7, 6}}});
    }
    for (const Agent& agent : world.mission.agents) {
        world.plan.agents.push_back({.id = agent.id,
                                     .kind = agent.kind,
                                     .path = {{double(agent.start.x), double(agent.start.y), 0},
                                              {double(agent.goal.x), double(agent.goal.y), 7}}});
    }
    const auto picture = parsed(svg_of(world));
    EXPECT_TRUE(says(picture, "0.0 heli"));
    EXPECT_EQ(count(picture, "//circle[@fill='#f6e27a']"), 1U);  // the second aircraft's colour
    EXPECT_EQ(count(picture, "//path[@stroke='#f6e27a']"), 1U);

    world.mission.agents.erase(world.mission.agents.begin() + 1);  // one aircraft alone needs no mark
    world.plan.agents.erase(world.plan.agents.begin() + 1);
    world.mission.agents.push_back({.id = "2", .start = {0, 0}, .goal = {7, 0}});
    EXPECT_FALSE(says(parsed(svg_of(world)), "0.0 heli"));
}

TEST(Picture, ManyRemovalsAreNotNumbered) {
    World world = wall();
    world.plan.breaches.assign(5000, world.plan.breaches.front());
    EXPECT_FALSE(says(parsed(svg_of(world)), "2"));
}

TEST(Picture, SameInputSameBytes) {
    EXPECT_EQ(svg_of(wall()), svg_of(wall()));
}

TEST(Picture, CityIsSmall) {
    const auto city = shared_city("Berlin_0_512.map");
    if (!city) GTEST_SKIP() << "no shared city maps here";
    EXPECT_LT(svg_of(unsolved(*city, {236, 13}, {388, 398})).size(), 60'000U);
}

// The worst map there is: noise, which no outline shortens. Drawn coarse, its size is bounded by the picture's.
TEST(Picture, NoiseStaysBounded) {
    std::mt19937 random(1);
    std::size_t sizes[2];
    for (const int doubling : {0, 1}) {
        const int side = 2048 << doubling;
        Grid grid(side, side);
        for (int y = 0; y < side; ++y) {
            for (int x = 0; x < side; ++x) grid.set_blocked({x, y}, random() % 2 == 0);
        }
        const World world = unsolved(Map(std::move(grid)), {0, 0}, {side - 1, side - 1});
        sizes[doubling] = svg_of(world, {.width = 400}).size();
    }
    EXPECT_LT(sizes[0], 4'000'000U);
    EXPECT_LT(sizes[1], 1.2 * double(sizes[0]));
}

}  // namespace
}  // namespace waybreaker::render
