// Windows that reach beyond the data: what lies there, for whom, and what maps say of it.
#include "site/unknown_ground.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "city/city_import.hpp"
#include "city/osm_drawing.hpp"
#include "temporary_folder.hpp"

namespace waybreaker::city {
namespace {

// A letter for each cell: ? for unknown ground, x for what else cannot be destroyed, o for what can.
std::string picture(const geotiff::LabelTiff& tiff) {
    const std::vector<bool> unknown = site::unknown_obstacles(tiff.map, tiff.annotations.tags);
    std::string text;
    for (Cell c; c.y < tiff.map.height(); ++c.y) {
        for (c.x = 0; c.x < tiff.map.width(); ++c.x) {
            const ObstacleId id = tiff.map.obstacle_at(c);
            if (!id) {
                text += '.';
            } else {
                text += unknown[id.value] ? '?' : tiff.map.obstacle(id).destructible ? 'o' : 'x';
            }
        }
        text += '\n';
    }
    return text;
}

// Its unknown cells, row by row.
std::vector<site::CellRun> unknown_runs(const geotiff::LabelTiff& tiff) {
    const std::string cells = picture(tiff);
    const int columns = tiff.map.width() + 1;
    std::vector<site::CellRun> runs;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        if (cells[i] != '?') continue;
        if (i == 0 || cells[i - 1] != '?') runs.push_back({{int(i) % columns, int(i) / columns}, 0});
        ++runs.back().length;
    }
    return runs;
}

class UnknownGround : public TemporaryFolder {
  protected:
    // Half of the window: two houses, one across the edge of the data; a pond and a street, both likewise.
    OsmDrawing drawing_ = OsmDrawing(town_window)
                              .ends(-3, -3, 7, 17)
                              .area("building=yes", box(0.9, 0.9, 4.1, 3.1))
                              .area("building=yes", box(4.9, 4.9, 9.1, 7.1))
                              .area("natural=water", box(5.9, 11.9, 10.1, 13.1))
                              .way("highway=footway", {{-3, 9.5}, {17, 9.5}});

    ImportReport import(ImportOptions options = town_window) const {
        return import_city(put("town.osm", drawing_.xml()), options);
    }
};

TEST_F(UnknownGround, LiesBeyondTheDataWhereNothingIsKnown) {
    const ImportReport report = import();
    EXPECT_EQ(picture(report.tiff),
              ".......???????\n"
              ".oooo..???????\n"
              ".oooo..???????\n"
              ".oooo..???????\n"
              ".......???????\n"
              ".....ooooo????\n"
              ".....ooooo????\n"
              ".....ooooo????\n"
              ".......???????\n"
              ".......???????\n"
              ".......???????\n"
              ".......???????\n"
              "......xxxxx???\n"
              "......xxxxx???\n");
    EXPECT_NEAR(report.covered, 0.5, 0.02);
    EXPECT_TRUE(report.unknown_beyond);
    const site::Annotations& known = report.tiff.annotations;
    for (const ObstacleId id : known.tags.at(site::unknown_tag)) {
        EXPECT_FALSE(report.tiff.map.obstacle(id).destructible);
        EXPECT_EQ(site::kind_of(known.kinds, id), site::ObstacleKind::unknown);
    }
    EXPECT_EQ(known.notes, std::vector<std::string>{});  // the map shows it
}

// Nodes on either side, with bounds and without.
TEST_F(UnknownGround, IsNotTheGroundAcrossTheDateLine) {
    ImportOptions fiji = town_window;
    fiji.longitude = 180;
    fiji.latitude = -17;
    OsmDrawing town = OsmDrawing(fiji)
                          .area("building=yes", box(0.9, 0.9, 4.1, 3.1))
                          .way("highway=footway", {{-3, -3}, {17, 17}})
                          .way("highway=footway", {{-3, 17}, {17, -3}});
    EXPECT_EQ(import_city(put("fiji.osm", town.xml()), fiji).covered, 1);
    EXPECT_EQ(import_city(put("fiji.osm", town.without_bounds().xml()), fiji).covered, 1);
}

TEST_F(UnknownGround, IsOneObstacleForEachConnectedSet) {
    drawing_.ends(3, -3, 7, 17);
    const ImportReport report = import();
    EXPECT_EQ(report.tiff.annotations.tags.at(site::unknown_tag).size(), 2U);
}

TEST_F(UnknownGround, StaysWholeInSections) {
    ImportOptions options = town_window;
    options.section = 8;
    const ImportReport report = import(options);
    EXPECT_EQ(report.tiff.annotations.tags.at(site::unknown_tag).size(), 1U);
    EXPECT_FALSE(report.tiff.annotations.sections.empty());
}

TEST_F(UnknownGround, IsFreeForWhoAsksForThat) {
    ImportOptions options = town_window;
    options.unknown_free = true;
    const ImportReport report = import(options);
    EXPECT_EQ(picture(report.tiff).find('?'), std::string::npos);
    EXPECT_FALSE(report.unknown_beyond);
    EXPECT_EQ(report.tiff.annotations.unknown, unknown_runs(import().tiff));
    ASSERT_EQ(report.tiff.annotations.notes.size(), 1U);
    EXPECT_NE(report.tiff.annotations.notes[0].find("of the window; the rest is free on the map"), std::string::npos);
}

TEST_F(UnknownGround, IsNothingThatThePaperKnows) {
    ImportOptions options = town_window;
    options.profile = Profile::paper;
    const ImportReport report = import(options);
    EXPECT_EQ(picture(report.tiff).find('?'), std::string::npos);
    EXPECT_FALSE(report.unknown_beyond);
}

TEST_F(UnknownGround, BeginsWhereFilesWithoutBoundsHaveNothingMore) {
    drawing_.without_bounds();
    const std::string seen = picture(import().tiff);
    EXPECT_EQ(seen.find('?'), 0U);                // above the first house
    EXPECT_EQ(seen[town_side + 1], '.') << seen;  // beside it, where the street goes on further below
}

TEST_F(UnknownGround, IsNoTileOfItsOwn) {
    std::vector<std::string> seen;
    const auto all = import_tiles(put("town.osm", drawing_.xml()), town_window, town_side, [&](const ImportTile& tile) {
        seen.push_back(std::to_string(tile.column) + std::to_string(tile.row));
    });
    EXPECT_EQ(all, 4U);
    EXPECT_EQ(seen, (std::vector<std::string>{"00", "10", "01", "11"}));
    drawing_ = OsmDrawing(town_window)
                   .ends(-3, -3, 7, 17)
                   .area("building=yes", box(0.9, 0.9, 4.1, 3.1))
                   .way("highway=footway", {{-3, 9.5}, {17, 9.5}});
    seen.clear();
    import_tiles(put("town.osm", drawing_.xml()), town_window, town_side, [&](const ImportTile& tile) {
        seen.push_back(std::to_string(tile.column) + std::to_string(tile.row));
    });
    EXPECT_EQ(seen, std::vector<std::string>{"00"});
}

// A lake whose outline is not whole in the file may be on either side of what is left of it.
TEST_F(UnknownGround, IsWhereACutLakeMayBe) {
    drawing_ = OsmDrawing(town_window).area("building=yes", box(-0.2, -0.2, 0.2, 0.2));
    drawing_.way("", {{-2.5, 4.5}, {16.2, 4.5}});
    drawing_.relation("natural=water|name=See", {drawing_.last(), 4711});
    drawing_.way("", {{-3, 0.4}, {17, 0.4}});
    const std::int64_t north = drawing_.last();
    drawing_.way("", {{-3, 17}, {17, 17}});
    drawing_.relation("landuse=military|name=Range", {north, drawing_.last(), 4711});
    ImportOptions options = town_window;
    const ImportReport report = import(options);
    const std::string text = picture(report.tiff);
    EXPECT_EQ(std::count(text.begin(), text.end(), '?'), 4 * 14) << text;
    ASSERT_FALSE(report.notes.empty());
    EXPECT_EQ(report.notes.front(),
              "See: its outline is not whole in the file; where it may be is unknown ground and bars the way");
    options.unknown_free = true;
    EXPECT_EQ(picture(import(options).tiff).find('?'), std::string::npos);
}

TEST_F(UnknownGround, IsAlsoThatOfSourcesWithNothingButBuildings) {
    drawing_ = OsmDrawing(town_window).area("building=yes", box(-0.2, -0.2, 0.2, 0.2));
    const std::vector<std::string> notes = import().notes;
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_NE(notes.front().find("only buildings bar the way"), std::string::npos);
}

// A box around four buildings says nothing of the ground beside them.
TEST_F(UnknownGround, IsNotBesideTheBuildingsOfOtherSources) {
    const std::string json =
        R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{"building":"yes"},)"
        R"("geometry":{"type":"Polygon","coordinates":[[[13.3999,52.5199],[13.4,52.5199],)"
        R"([13.4,52.52],[13.3999,52.52],[13.3999,52.5199]]]}}]})";
    const ImportReport report = import_city(put("town.geojson", json), town_window);
    EXPECT_EQ(picture(report.tiff).find('?'), std::string::npos);
    EXPECT_LT(report.covered, 0.5);
    EXPECT_NE(report.tiff.annotations.notes.back().find("the rest is free on the map"), std::string::npos);
}

TEST_F(UnknownGround, IsWhatFilteredExtractsLeaveOutOfTheCity) {
    const auto notes = [&](int houses) {
        OsmDrawing drawing(town_window);
        for (int i = 0; i < 14; ++i) drawing.way("highway=residential", {{double(i), -3}, {double(i), 16}});
        for (int i = 0; i < houses; ++i) drawing.area("building=yes", box(i, 2, i + 0.9, 3));
        return import_city(put("roads.osm", drawing.xml()), town_window).tiff.annotations.notes;
    };
    const std::vector<std::string> one = notes(1);
    ASSERT_EQ(one.size(), 1U);
    EXPECT_EQ(one[0].find("1 building beside 14 streets: was the extract filtered?"), 0U) << one[0];
    EXPECT_TRUE(notes(2).empty());
}

}  // namespace
}  // namespace waybreaker::city
