// Rivers, coasts, motorways, walls and passages drawn in cells: what bars the way, for whom, and what lies beneath.
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "city/city_import.hpp"
#include "city/ground_picture.hpp"
#include "city/osm_drawing.hpp"
#include "temporary_folder.hpp"

namespace waybreaker::city {
namespace {

class Ground : public TemporaryFolder {
  protected:
    // A small building in the corner, so that there is something to import.
    OsmDrawing drawing_ = OsmDrawing(town_window).area("building=yes", box(-0.2, -0.2, 0.2, 0.2));

    ImportReport import(const OsmDrawing& drawing, ImportOptions options = town_window) const {
        return import_city(put("town.osm", drawing.xml()), options);
    }
    std::string drawn(std::optional<Profile> profile = {}) const {
        ImportOptions options = town_window;
        options.profile = profile;
        return picture(import(drawing_, options).tiff);
    }
};

TEST_F(Ground, of_a_river_is_crossed_on_its_bridge) {
    drawing_.area("natural=water", box(-1, 4.6, 14, 8.4));
    drawing_.way("highway=residential|bridge=yes|width=6", {{6, 2}, {6, 11}});
    drawing_.way("highway=residential|bridge=yes|access=private", {{11, 2}, {11, 11}});
    EXPECT_EQ(drawn(),
              "B.............\n"
              "..........xxx.\n"
              "....c...c.xxx.\n"
              "....c...c.xxx.\n"
              "....c...c.xxx.\n"
              "wwwww...wwxxxw\n"
              "wwwww...wwxxxw\n"
              "wwwww...wwxxxw\n"
              "wwwww...wwxxxw\n"
              "....c...c.xxx.\n"
              "....c...c.xxx.\n"
              "....c...c.xxx.\n"
              "..........xxx.\n"
              "..............\n");
}

TEST_F(Ground, below_a_viaduct_leads_up_only_at_its_ends) {
    drawing_.way("highway=residential|bridge=viaduct|layer=2|width=6", {{6, 1.7}, {6, 5}});
    drawing_.way("highway=residential|bridge=viaduct|layer=2|width=6", {{6, 5}, {6, 11.3}});
    drawing_.way("highway=path", {{6, 8}, {13, 8}});
    const std::string free = "..............\n";
    const std::string wide = "....c...c.....\n";
    const std::string joined = "....c.........\n";
    EXPECT_EQ(drawn(), "B.............\n" + free + wide + wide + wide + wide + wide + wide + joined + wide + wide +
                           wide + free + free);
}

TEST_F(Ground, off_the_roads_bars_trucks) {
    drawing_.way("highway=residential|width=6", {{-1, 1}, {14, 1}});
    drawing_.way("highway=residential|width=6", {{-1, 12}, {14, 12}});
    drawing_.area("building=yes", box(4.6, 3.6, 8.4, 9.4));
    const std::string road = "..............\n..............\n..............\n";
    EXPECT_EQ(drawn(Profile::truck), road +
                                         "---........---\n"
                                         "---..BBBB..---\n"
                                         "----.BBBB.----\n"
                                         "-----BBBB-----\n"
                                         "-----BBBB-----\n"
                                         "----.BBBB.----\n"
                                         "---..BBBB..---\n"
                                         "---........---\n" +
                                         road);
}

TEST_F(Ground, beside_a_stile_leads_around_it) {
    drawing_.point("barrier=stile", {6, 6}, true).way("highway=path", {{6, 0}, {6, 6}, {6, 13}});
    const std::string free = "..............\n";
    EXPECT_EQ(drawn(), "B.............\n" + free + free + free + free + free + "......b.......\n" + free + free + free +
                           free + free + free + free);
    EXPECT_EQ(drawn(Profile::walker).find('b'), std::string::npos);
}

TEST_F(Ground, is_that_of_its_profile) {
    drawing_.way("highway=residential", {{-1, 6}, {14, 6}});
    const auto profile = [&](std::optional<Profile> given) {
        ImportOptions options = town_window;
        options.profile = given;
        return import(drawing_, options).tiff.annotations.profile;
    };
    EXPECT_EQ(profile({}), Profile::rover);
    EXPECT_EQ(profile(Profile::truck), Profile::truck);
    EXPECT_EQ(profile(Profile::paper), std::nullopt);
}

TEST_F(Ground, of_a_river_that_is_a_line_is_a_strip) {
    drawing_.way("waterway=river|width=6", {{-1, 6}, {14, 6}});
    drawing_.way("waterway=canal|tunnel=culvert", {{-1, 11}, {14, 11}});
    drawing_.way("waterway=stream", {{-1, 12}, {14, 12}});
    drawing_.way("highway=footway", {{3, 0}, {3, 13}});  // a bridge that nobody says is one
    drawing_.way("highway=footway|tunnel=yes", {{9, 0}, {9, 13}});
    const std::string dry = "..............\n";
    const std::string river = "www.wwwwwwwwww\n";
    EXPECT_EQ(drawn(),
              "B.............\n" + dry + dry + dry + dry + river + river + river + dry + dry + dry + dry + dry + dry);
}

TEST_F(Ground, leaves_the_line_of_a_river_to_its_area) {
    drawing_.area("natural=water", box(-1, 4.6, 8.4, 6.4));
    drawing_.way("waterway=river", {{-1, 5.5}, {7.5, 5.5}});
    const std::string text = drawn();
    EXPECT_EQ(std::count(text.begin(), text.end(), 'w'), 2 * 9) << text;
}

TEST_F(Ground, has_the_sea_on_the_right_of_its_coast) {
    drawing_.way("natural=coastline", {{-3, 5.5}, {8.5, 5.5}, {8.5, -3}});  // eastwards: the south is sea
    drawing_.way("natural=coastline", {{3.5, 8.5}, {3.5, 10.5}, {5.5, 10.5}, {5.5, 8.5}, {3.5, 8.5}});  // an island
    drawing_.way("man_made=pier|width=2", {{10, 5}, {13.5, 5}});
    EXPECT_EQ(drawn(),
              "B........wwwww\n"
              ".........wwwww\n"
              ".........wwwww\n"
              ".........wwwww\n"
              ".........wwwww\n"
              ".........w....\n"
              "wwwwwwwwwwwwww\n"
              "wwwwwwwwwwwwww\n"
              "wwwwwwwwwwwwww\n"
              "wwww..wwwwwwww\n"
              "wwww..wwwwwwww\n"
              "wwwwwwwwwwwwww\n"
              "wwwwwwwwwwwwww\n"
              "wwwwwwwwwwwwww\n");
    EXPECT_TRUE(import(drawing_).notes.empty());
}

// As extracts have it whose ways end at the last point within.
TEST_F(Ground, has_the_sea_beside_a_coast_that_ends_before_the_edge) {
    drawing_.way("natural=coastline", {{0.8, 5.5}, {12.2, 5.5}});
    const std::string text = drawn();
    EXPECT_EQ(std::count(text.begin(), text.end(), 'w'), 8 * 14) << text;
    EXPECT_TRUE(import(drawing_).notes.empty());
}

TEST_F(Ground, reports_a_coast_that_ends_within) {
    drawing_.way("natural=coastline", {{-3, 5.5}, {8.5, 5.5}});
    const std::vector<std::string> notes = import(drawing_).notes;
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_NE(notes.front().find("a coastline ends within the window"), std::string::npos);
    EXPECT_NE(drawn().find("wwwwwwwww.....\n"), std::string::npos) << drawn();
}

TEST_F(Ground, of_a_motorway_is_crossed_below_and_above) {
    drawing_.way("highway=motorway|width=6", {{-1, 6}, {14, 6}});
    drawing_.way("highway=footway|tunnel=yes|layer=-1", {{2, 3}, {2, 9}});
    drawing_.way("highway=service|bridge=yes|layer=1", {{6, 3}, {6, 9}});
    drawing_.way("highway=service|access=private|width=2", {{10, 3}, {10, 5}});
    drawing_.way("highway=steps", {{12, 3}, {12, 9}});
    const std::string free = "..............\n";
    const std::string north = "B.............\n" + free + free;
    const std::string south = free + free + free + free;
    const std::string road = "xx.xxx.xxxxxxx\n";
    EXPECT_EQ(drawn(), north + "..........x.c.\n....c...c.x.c.\n" + road + road + road +
                           "....c...c...c.\n............c.\n" + south);
    const std::string walked = "xx.xxx.xxxxx.x\n";
    EXPECT_EQ(drawn(Profile::walker), north + "..........x...\n....c...c.x...\n" + walked + walked + walked +
                                          "....c...c.....\n..............\n" + south);
    EXPECT_EQ(drawn(Profile::truck),
              "B-------------\n"
              "--------------\n"
              "------.-------\n"
              "-----...--x-c-\n"
              "---cc...ccx-c-\n" +
                  free + free + free +
                  "---cc...cc--c-\n"
                  "-----...----c-\n"
                  "------.-------\n"
                  "--------------\n"
                  "--------------\n"
                  "--------------\n");
    EXPECT_EQ(import(drawing_, {.longitude = 13.4, .latitude = 52.52, .size = 28, .cell = 2, .profile = Profile::paper})
                  .tiff.annotations.kinds.size(),
              0U);
}

TEST_F(Ground, of_tracks_is_crossed_where_a_way_does) {
    drawing_.way("railway=rail", {{-1, 6}, {14, 6}});
    drawing_.way("railway=tram", {{-1, 9}, {14, 9}});
    drawing_.way("railway=disused", {{-1, 10}, {14, 10}});
    drawing_.way("railway=subway|tunnel=yes", {{-1, 11}, {14, 11}});
    drawing_.way("highway=path", {{4, 0}, {4, 13}});
    const std::string text = drawn();
    EXPECT_NE(text.find("\nxxxx.xxxxxxxxx\n"), std::string::npos) << text;
    EXPECT_EQ(std::count(text.begin(), text.end(), 'x') % 13, 0) << text;
}

TEST_F(Ground, of_a_barracks_has_no_public_ways) {
    drawing_.area("landuse=military", box(2.5, 2.5, 6.5, 6.5));
    drawing_.area("leisure=park|access=private", box(8.5, 2.5, 12.5, 6.5));
    drawing_.way("highway=residential", {{0, 4}, {13, 4}});
    const std::string shut = "...xxxx..xxxx.\n";
    const std::string text = drawn();
    EXPECT_NE(text.find(shut + "...xxxx.......\n" + shut + shut), std::string::npos) << text;
}

TEST_F(Ground, behind_a_wall_is_reached_by_gates_and_ways) {
    drawing_.way("barrier=wall", {{-1, 4}, {5, 4}, {14, 4}}).point("barrier=gate", {2, 4});
    drawing_.point("barrier=gate|access=private", {8, 4});
    drawing_.way("highway=track", {{11, 0}, {11, 13}});
    drawing_.way("barrier=city_wall|width=2", {{-1, 9}, {14, 9}}).point("barrier=gate", {2, 9});
    drawing_.way("barrier=kerb", {{-1, 12}, {14, 12}});
    const std::string text = drawn();
    EXPECT_NE(text.find("\nbb..bbbbbbb.bb\n"), std::string::npos) << text;
    EXPECT_NE(text.find("\nccccccccccc.cc\n"), std::string::npos) << text;
    EXPECT_EQ(std::count(text.begin(), text.end(), 'b'), 11) << text;
    EXPECT_EQ(std::count(text.begin(), text.end(), 'c'), 13) << text;
}

TEST_F(Ground, of_a_fenced_pitch_is_open_inside) {
    drawing_.area("leisure=pitch|barrier=fence", box(3, 3, 7, 7));
    drawing_.area("barrier=hedge|area=yes", box(9.6, 2.6, 12.4, 5.4));
    const std::string text = drawn();
    EXPECT_NE(text.find("...bbbbb..bbb.\n...b...b..bbb.\n...b...b..bbb.\n...b...b......\n"), std::string::npos) << text;
}

TEST_F(Ground, of_a_passage_leads_through_the_building) {
    drawing_.area("building=yes", box(1.6, 1.6, 11.4, 4.4));
    drawing_.way("highway=service|tunnel=building_passage", {{5, 0}, {5, 7}});
    drawing_.way("highway=corridor|indoor=yes", {{9, 0}, {9, 7}});
    drawing_.area("building=roof", box(1.6, 7.6, 11.4, 9.4));
    drawing_.area("building=garage|layer=-1|location=underground", box(1.6, 10.6, 11.4, 12.4));
    const std::string house = "..BBB.BBBBBB..\n";
    const std::string free = "..............\n";
    EXPECT_EQ(drawn(), "B.............\n" + free + house + house + house + free + free + free + free + free + free +
                           free + free + free);
}

TEST_F(Ground, of_a_passage_is_as_wide_as_the_vehicle) {
    drawing_.area("building=yes", box(1.6, 1.6, 11.4, 4.4));
    drawing_.way("highway=service|tunnel=building_passage", {{5.25, 0}, {5.25, 7}});
    const auto gap = [&](Profile profile) {
        ImportOptions fine = town_window;
        fine.cell = 1;
        fine.profile = profile;
        const std::string text = picture(import(drawing_, fine).tiff);
        const std::string row = text.substr(std::size_t(6 * (2 * town_side + 1)), 2 * town_side);
        return std::count(row.begin() + 5, row.begin() + 20, '.');
    };
    EXPECT_EQ(gap(Profile::rover), 1);
    EXPECT_EQ(gap(Profile::truck), 3);
}

TEST_F(Ground, stays_under_a_house_that_is_destroyed) {
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
TEST_F(Ground, is_left_when_all_is_destroyed) {
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

TEST_F(Ground, that_is_unknown_is_reported) {
    ASSERT_EQ(import(drawing_).notes.size(), 1U);
    EXPECT_NE(import(drawing_).notes.front().find("only buildings bar the way"), std::string::npos);
}

TEST_F(Ground, protects_hospitals_unless_somebody_says_what_can_be_destroyed) {
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

TEST_F(Ground, has_the_barriers_destroyed_that_the_user_wants) {
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

TEST_F(Ground, merges_neither_barriers_nor_what_is_protected_with_houses) {
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

TEST_F(Ground, lies_in_tiles_as_in_the_whole) {
    drawing_.area("natural=water", box(-1, 4.6, 14, 8.4));
    drawing_.way("highway=residential|bridge=yes|width=6", {{6, 2}, {6, 11}});
    std::vector<std::string> tiles;
    import_tiles(put("town.osm", drawing_.xml()), town_window, 14,
                 [&](const ImportTile& tile) { tiles.push_back(picture(tile.report.tiff)); });
    ASSERT_EQ(tiles.size(), 4U);
    EXPECT_EQ(tiles[1],
              ".......\n"
              ".......\n"
              ".c.....\n"
              ".c.....\n"
              ".c.....\n"
              ".wwwwww\n"
              ".wwwwww\n");
}

TEST_F(Ground, bears_the_obstacles_that_are_chosen_in_place_of_buildings) {
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
