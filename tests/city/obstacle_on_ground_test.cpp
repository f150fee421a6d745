// What may be destroyed on true ground, and what lies beneath it.
#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

#include "city/ground_picture.hpp"
#include "city/town_ground.hpp"

namespace waybreaker::city {
namespace {

using ObstacleOnGround = TownGround;

TEST_F(ObstacleOnGround, stays_under_a_house_that_is_destroyed) {
    drawing_.area("natural=water", box(-1, 4.6, 14, 8.4));
    drawing_.area("building=yes", box(3.6, 2.6, 6.4, 6.4));
    drawing_.way("barrier=fence", {{10, 2}, {10, 7}});
    const ImportReport report = import(drawing_);
    EXPECT_EQ(picture(report.tiff),
              "B.............\n"
              "..............\n"
              "..........b...\n"
              "....BBB...b...\n"
              "....BBB...b...\n"
              "wwwwwwwwwwwwww\n"
              "wwwwwwwwwwwwww\n"
              "wwwwwwwwwwwwww\n"
              "wwwwwwwwwwwwww\n"
              "..............\n"
              "..............\n"
              "..............\n"
              "..............\n"
              "..............\n");
    for (const Obstacle& obstacle : report.tiff.map.obstacles()) {
        const bool water = report.tiff.annotations.kinds[obstacle.id.value] == site::ObstacleKind::water;
        EXPECT_EQ(obstacle.destructible, !water);
    }
}

// Random features of a town, drawn where they may lie over each other.
class RandomTown {
  public:
    explicit RandomTown(unsigned seed) : random_(seed) {}

    int pick(int below) { return int(random_() % unsigned(below)); }
    std::vector<Point> any_box() {
        const int x = pick(town_side);
        const int y = pick(town_side);
        return box(x - 0.4, y - 0.4, x + pick(6) + 0.4, y + pick(6) + 0.4);
    }
    std::vector<Point> line() {
        return {{double(pick(town_side)), double(pick(town_side))}, {double(pick(town_side)), pick(town_side) + 0.3}};
    }
    OsmDrawing ground() {
        const std::vector<std::string> areas{"natural=water", "landuse=military", "leisure=garden|access=private"};
        const std::vector<std::string> lines{"waterway=river|width=4",    "natural=cliff", "railway=rail",
                                             "highway=motorway",          "highway=path",  "highway=service|bridge=yes",
                                             "highway=footway|tunnel=yes"};
        OsmDrawing town = OsmDrawing(town_window).area("building=yes", box(-0.2, -0.2, 0.2, 0.2));
        for (int i = pick(4); i > 0; --i) town.area(areas[std::size_t(pick(int(areas.size())))], any_box());
        for (int i = pick(5); i > 0; --i) town.way(lines[std::size_t(pick(int(lines.size())))], line());
        return town;
    }
    OsmDrawing built_on(OsmDrawing town) {
        for (int i = 1 + pick(4); i > 0; --i) town.area("building=yes", any_box());
        for (int i = pick(4); i > 0; --i) town.way("barrier=wall", line());
        return town;
    }

  private:
    std::mt19937 random_;
};

// With every destructible obstacle destroyed, a town is the same town built on nothing: no cell of water or forbidden
// ground has opened.
TEST_F(ObstacleOnGround, is_left_when_all_is_destroyed) {
    for (unsigned seed = 0; seed < 40; ++seed) {
        SCOPED_TRACE(seed);
        RandomTown random(seed);
        const OsmDrawing ground = random.ground();
        ImportOptions options = town_window;
        options.merge_touching = seed % 2 == 0;
        const geotiff::LabelTiff before = import(ground, options).tiff;
        const geotiff::LabelTiff after = import(random.built_on(ground), options).tiff;
        for (Cell c; c.y < town_side; ++c.y) {
            for (c.x = 0; c.x < town_side; ++c.x) {
                const ObstacleId lasting = before.map.obstacle_at(c);
                const ObstacleId left = after.map.obstacle_at(c);
                const bool blocked = lasting && !before.map.obstacle(lasting).destructible;
                ASSERT_EQ(blocked, left && !after.map.obstacle(left).destructible) << picture(before) << picture(after);
                if (!blocked) continue;
                ASSERT_EQ(before.annotations.kinds[lasting.value], after.annotations.kinds[left.value]);
            }
        }
    }
}

TEST_F(ObstacleOnGround, protects_hospitals_unless_somebody_says_what_can_be_destroyed) {
    drawing_.area("building=yes|amenity=hospital", box(3.6, 2.6, 6.4, 3.4));
    EXPECT_NE(drawn().find("....PPP.......\n"), std::string::npos) << drawn();
    EXPECT_EQ(import(drawing_).sheltered, 1U);
    EXPECT_NE(drawn(Profile::truck).find("....PPP.......\n"), std::string::npos);
    ImportOptions options = town_window;
    options.choice.destructible = {{"building"}};
    const ImportReport report = import(drawing_, options);
    EXPECT_NE(picture(report.tiff).find("....BBB.......\n"), std::string::npos);
    EXPECT_EQ(report.sheltered, 0U);
}

TEST_F(ObstacleOnGround, has_the_barriers_destroyed_that_the_user_wants) {
    drawing_.way("barrier=wall", {{2, 4}, {6, 4}}).way("barrier=hedge", {{8, 4}, {12, 4}});
    const auto destructible = [&](const ObstacleChoice& choice) {
        ImportOptions options = town_window;
        options.choice = choice;
        const ImportReport report = import(drawing_, options);
        std::string text;
        for (const Obstacle& o : report.tiff.map.obstacles()) text += o.destructible ? 'd' : '-';
        return text;  // house, wall, hedge
    };
    EXPECT_EQ(destructible({}), "ddd");
    EXPECT_EQ(destructible({.destructible = {{"building"}}}), "d--");
    EXPECT_EQ(destructible({.protect = {{"barrier", {"wall"}}}}), "d-d");
}

TEST_F(ObstacleOnGround, merges_neither_barriers_nor_what_is_protected_with_houses) {
    drawing_.area("building=yes", box(2.6, 2.6, 4.5, 4.4));
    drawing_.area("building=yes", box(4.5, 2.6, 6.5, 4.4));
    drawing_.area("building=church", box(6.5, 2.6, 8.5, 4.4));
    drawing_.way("barrier=wall", {{3, 5}, {8, 5}});
    ImportOptions options = town_window;
    options.merge_touching = true;
    const geotiff::LabelTiff tiff = import(drawing_, options).tiff;
    EXPECT_EQ(tiff.map.obstacles().size(), 4U);  // with the one in the corner
    const std::string text = picture(tiff);
    EXPECT_NE(text.find("...BBBBPP.....\n...BBBBPP.....\n...bbbbbb.....\n"), std::string::npos) << text;
}

TEST_F(ObstacleOnGround, bears_the_obstacles_that_are_chosen_in_place_of_buildings) {
    drawing_.area("natural=water", box(-1, 4.6, 14, 8.4));
    drawing_.area("leisure=park", box(3.6, 2.6, 6.4, 6.4));
    drawing_.way("barrier=wall", {{10, 2}, {10, 7}});
    ImportOptions options = town_window;
    options.choice.obstacles = {{"leisure", {"park"}}};
    EXPECT_EQ(import(drawing_, options).tiff.map.obstacles().size(), 1U);  // as there is no profile
    options.profile = Profile::rover;
    const std::string text = picture(import(drawing_, options).tiff);
    EXPECT_NE(text.find("....???.......\n....???.......\nwwwwwwwwwwwwww\n"), std::string::npos) << text;
    EXPECT_EQ(text.find('b'), std::string::npos);
}

}  // namespace
}  // namespace waybreaker::city
