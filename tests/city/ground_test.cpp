// Rivers, coasts, motorways, walls and passages drawn in cells: what bars the way, for whom, and what lies beneath.
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "city/city_import.hpp"
#include "city/ground_picture.hpp"
#include "city/town_ground.hpp"

namespace waybreaker::city {
namespace {

using Ground = TownGround;

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

TEST_F(Ground, below_a_roof_is_a_car_park_but_in_a_house_is_none) {
    drawing_.area("building=yes|amenity=parking", box(2.6, 6.6, 5.4, 9.4));
    drawing_.area("building=roof|amenity=fuel", box(9.6, 6.6, 12.4, 9.4));
    const std::string wild = "--------------\n";
    const std::string both = "---BBB----...-\n";
    EXPECT_EQ(drawn(Profile::truck), "B-------------\n" + wild + wild + wild + wild + wild + wild + both + both + both +
                                         wild + wild + wild + wild);
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

TEST_F(Ground, that_is_unknown_is_reported) {
    ASSERT_EQ(import(drawing_).notes.size(), 1U);
    EXPECT_NE(import(drawing_).notes.front().find("only buildings bar the way"), std::string::npos);
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

}  // namespace
}  // namespace waybreaker::city
