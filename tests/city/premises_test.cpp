// Grounds of hospitals, schools and heritage: what stands on them is protected as if it said so itself.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include "city/city_import.hpp"
#include "city/import_window.hpp"
#include "city/osm_drawing.hpp"
#include "input_error.hpp"
#include "temporary_folder.hpp"

namespace waybreaker::city {
namespace {

// A letter for each obstacle, row by row: destructible or -.
std::string fates(const geotiff::LabelTiff& tiff) {
    std::string text;
    for (const Obstacle& o : tiff.map.obstacles()) text += o.destructible ? 'd' : '-';
    return text;
}

class PremisesOfHouses : public TemporaryFolder {
  protected:
    ImportReport import(const OsmDrawing& drawing, const ImportOptions& options = town_window) const {
        return import_city(put("town.osm", drawing.xml()), options);
    }
    // Three houses of 2 x 3 cells: at columns 2, 6 and 10 of the rows 4 to 6.
    static OsmDrawing houses() {
        OsmDrawing drawing(town_window);
        for (const double west : {1.6, 5.6, 9.6}) {
            drawing.area("building=yes", box(west, 3.6, west + 1.8, 6.4));
        }
        return drawing;
    }
};

TEST_F(PremisesOfHouses, hold_more_than_half_of_a_house) {
    // All of the first house, two columns of three rows: half of the second.
    OsmDrawing drawing = houses().area("amenity=hospital|name=Charité", box(0.5, 2.5, 6.5, 7.5));
    const ImportReport report = import(drawing);
    EXPECT_EQ(fates(report.tiff), "-dd");
    EXPECT_EQ(report.sheltered, 1U);
    EXPECT_EQ(report.tiff.annotations.tags.at("amenity=hospital"), std::vector<ObstacleId>{{1}});
    EXPECT_EQ(report.tiff.annotations.tags.at("building=yes").size(), 3U);
    EXPECT_EQ(report.tiff.annotations.names.at(1), "Charité");
    EXPECT_EQ(report.tiff.annotations.names.at(2), "");
    drawing.area("amenity=hospital", box(6.5, 3.5, 7.5, 4.5));  // a cell more
    EXPECT_EQ(fates(import(drawing).tiff), "--d");
}

TEST_F(PremisesOfHouses, may_be_of_several_kinds) {
    OsmDrawing drawing = houses().area("amenity=hospital|heritage=4", box(0.5, 2.5, 8.5, 7.5));
    drawing.area("amenity=kindergarten|name=Hummeln", box(1.5, 3.5, 4.5, 7.5));
    drawing.area("landuse=religious", box(9.5, 2.5, 12.5, 7.5));
    const geotiff::LabelTiff tiff = import(drawing).tiff;
    EXPECT_EQ(fates(tiff), "---");
    EXPECT_EQ(tiff.annotations.tags, (site::ObstacleTags{{"amenity=hospital", {{1}, {2}}},
                                                         {"amenity=kindergarten", {{1}}},
                                                         {"building=yes", {{1}, {2}, {3}}},
                                                         {"heritage=4", {{1}, {2}}},
                                                         {"landuse=religious", {{3}}}}));
    EXPECT_EQ(tiff.annotations.names.at(1), "Hummeln");
}

TEST_F(PremisesOfHouses, leave_a_house_its_own_name_and_tags) {
    OsmDrawing drawing(town_window);
    drawing.area("building=yes|addr:street=Weg|addr:housenumber=1|amenity=cafe", box(1.6, 3.6, 3.4, 6.4));
    drawing.area("building=yes|amenity=school|name=Aula", box(5.6, 3.6, 7.4, 6.4));
    drawing.area("amenity=school|name=Gymnasium", box(0.5, 2.5, 8.5, 7.5));
    const geotiff::LabelTiff tiff = import(drawing).tiff;
    EXPECT_EQ(tiff.annotations.names.at(1), "Weg 1");
    EXPECT_EQ(tiff.annotations.names.at(2), "Aula");
    EXPECT_EQ(
        tiff.annotations.tags,
        (site::ObstacleTags{{"amenity=cafe", {{1}}}, {"amenity=school", {{1}, {2}}}, {"building=yes", {{1}, {2}}}}));
}

TEST_F(PremisesOfHouses, may_be_relations_with_courtyards) {
    OsmDrawing drawing = houses();
    drawing.way("", {{0.5, 7.5}, {0.5, 2.5}, {8.5, 2.5}});
    const std::int64_t half = drawing.last();
    drawing.way("", {{8.5, 2.5}, {8.5, 7.5}, {0.5, 7.5}});
    const std::int64_t other_half = drawing.last();
    // Within the outer ring another one is a hole, whatever its role.
    drawing.way("", {{5.2, 3.2}, {7.8, 3.2}, {7.8, 6.8}, {5.2, 6.8}, {5.2, 3.2}});
    drawing.relation("amenity=school", {half, other_half, drawing.last()});
    EXPECT_EQ(fates(import(drawing).tiff), "-dd");
}

TEST_F(PremisesOfHouses, may_be_points_within) {
    OsmDrawing drawing = houses();
    drawing.point("amenity=hospital|name=Praxis", {2.5, 5});
    drawing.point("historic=memorial|memorial=stolperstein", {6.5, 5});
    drawing.point("amenity=school", {11.6, 5});  // beside the third house, by less than half a cell
    const geotiff::LabelTiff tiff = import(drawing).tiff;
    EXPECT_EQ(fates(tiff), "-dd");
    EXPECT_EQ(tiff.annotations.tags.at("amenity=hospital"), std::vector<ObstacleId>{{1}});
    EXPECT_EQ(tiff.annotations.names.at(1), "Praxis");
    // By the wall, where the cell's centre is outside; and heritage that is a house.
    drawing.point("amenity=kindergarten", {5.65, 3.65}).point("historic=manor", {10.5, 5});
    EXPECT_EQ(fates(import(drawing).tiff), "---");
}

TEST_F(PremisesOfHouses, let_their_fence_be_opened) {
    OsmDrawing drawing = houses().area("amenity=hospital", box(0.5, 2.5, 13.5, 7.5));
    drawing.way("barrier=fence", {{1, 12}, {12, 12}}).way("barrier=wall", {{4.5, 3}, {4.5, 7}});
    drawing.way("barrier=wall|historic=citywalls", {{8.5, 3}, {8.5, 7}});
    const geotiff::LabelTiff tiff = import(drawing).tiff;
    for (const Obstacle& o : tiff.map.obstacles()) {
        const bool wall = tiff.annotations.kinds[o.id.value] == site::ObstacleKind::barrier;
        const auto& old = tiff.annotations.tags.at("historic=citywalls");
        EXPECT_EQ(o.destructible, wall && std::find(old.begin(), old.end(), o.id) == old.end());
    }
}

TEST_F(PremisesOfHouses, keep_sections_off) {
    OsmDrawing drawing = houses().area("amenity=hospital", box(0.5, 2.5, 4.5, 7.5));
    ImportOptions options = town_window;
    options.section = 20;
    const geotiff::LabelTiff tiff = import(drawing, options).tiff;
    const ObstacleId ward = tiff.map.obstacle_at({2, 4});
    EXPECT_FALSE(tiff.map.obstacle(ward).destructible);
    EXPECT_EQ(tiff.map.obstacle(ward).cells, 6U);
    EXPECT_EQ(tiff.annotations.tags.at("amenity=hospital"), std::vector<ObstacleId>{ward});
    EXPECT_TRUE(tiff.map.obstacle(tiff.map.obstacle_at({6, 4})).destructible);
}

TEST_F(PremisesOfHouses, are_joined_with_no_neighbour) {
    OsmDrawing drawing(town_window);
    drawing.area("building=yes", box(1.6, 3.6, 4.5, 6.4)).area("building=yes", box(4.5, 3.6, 7.4, 6.4));
    drawing.area("amenity=school", box(0.5, 2.5, 4.5, 7.5));
    ImportOptions options = town_window;
    options.merge_touching = true;
    EXPECT_EQ(fates(import(drawing, options).tiff), "-d");
}

TEST_F(PremisesOfHouses, protect_what_the_user_wants) {
    OsmDrawing drawing = houses().area("amenity=hospital", box(0.5, 2.5, 4.5, 7.5));
    drawing.area("amenity=school", box(4.5, 2.5, 8.5, 7.5));
    drawing.area("leisure=park", box(8.5, 2.5, 13.5, 7.5));
    const auto imported = [&](const ObstacleChoice& choice, Profile profile = Profile::rover) {
        ImportOptions options = town_window;
        options.choice = choice;
        options.profile = profile;
        return import(drawing, options);
    };
    EXPECT_EQ(fates(imported({.protect = {{"amenity", {"hospital"}}}}).tiff), "-dd");
    EXPECT_EQ(fates(imported({.protect = {{"amenity", {"school"}}}}).tiff), "d-d");
    EXPECT_EQ(fates(imported({.destructible = {{"building"}}}).tiff), "ddd");
    EXPECT_EQ(imported({.destructible = {{"building"}}}).sheltered, 0U);
    // A mission can still protect them.
    EXPECT_EQ(imported({.destructible = {{"building"}}}).tiff.annotations.tags.at("amenity=hospital").size(), 1U);
    EXPECT_EQ(fates(imported({}, Profile::paper).tiff), "ddd");
    // Misspelt; and a house in a park is no park.
    for (const TagFilter& tag : {TagFilter{"amenity", {"hospitel"}}, TagFilter{"leisure", {"park"}}}) {
        EXPECT_NE(input_error([&] { imported({.protect = {tag}}); }).find("no obstacle of"), std::string::npos);
    }
}

TEST_F(PremisesOfHouses, of_tiles_hold_for_their_part_of_a_house) {
    OsmDrawing drawing(town_window);
    drawing.area("building=yes", box(3.6, 3.6, 9.4, 5.4));  // three columns in each tile
    drawing.area("amenity=hospital", box(0.5, 2.5, 6.5, 7.5));
    std::string text;
    import_tiles(put("town.osm", drawing.xml()), town_window, town_side,
                 [&](const ImportTile& tile) { text += fates(tile.report.tiff); });
    EXPECT_EQ(text, "-d");
}

TEST_F(PremisesOfHouses, may_come_as_geojson) {
    const geotiff::ToLonLat place(import_window(town_window).georeference);
    std::string features;
    const auto add = [&](const std::string& properties, const std::vector<Point>& ring) {
        std::string points;
        for (std::size_t i = 0; i <= ring.size(); ++i) {
            const auto [lon, lat] = place(ring[i % ring.size()].x, ring[i % ring.size()].y);
            points += fmt::format("{}[{:.7f},{:.7f}]", i == 0 ? "" : ",", lon, lat);
        }
        features += fmt::format(R"({}{{"type":"Feature","properties":{{{}}},"geometry":{{"type":"Polygon",)"
                                R"("coordinates":[[{}]]}}}})",
                                features.empty() ? "" : ",", properties, points);
    };
    add(R"("building":"yes")", box(1.6, 3.6, 3.4, 6.4));
    add(R"("building":"yes")", box(5.6, 3.6, 7.4, 6.4));
    add(R"("amenity":"school")", box(4.5, 2.5, 8.5, 7.5));
    const std::string file = put("town.geojson", R"({"type":"FeatureCollection","features":[)" + features + "]}");
    EXPECT_EQ(fates(import_city(file, town_window).tiff), "d-");
}

TEST_F(PremisesOfHouses, may_be_malformed) {
    OsmDrawing drawing = houses();
    // A bow, whose loops hold the first and the last house; a line there and back; far more than the window.
    drawing.area("amenity=school", {{-1, 2}, {15, 9}, {15, 2}, {-1, 9}});
    drawing.area("historic=ruins", {{1, 1}, {9, 9}});
    drawing.area("amenity=hospital", {{3, 3}, {3, 3}, {3, 3}});
    EXPECT_EQ(fates(import(drawing).tiff), "-d-");
    drawing.area("historic=district|heritage=1", box(-1e4, -1e4, 1e4, 1e4));
    EXPECT_EQ(fates(import(drawing).tiff), "---");
    for (int i = 0; i < 2000; ++i) drawing.area("historic=district", box(-100 - i, -100, 100, 100));
    EXPECT_EQ(fates(import(drawing).tiff), "---");
}

struct RandomTown {
    explicit RandomTown(unsigned seed) : random(seed) {}

    int pick(int below) { return int(random() % unsigned(below)); }
    std::vector<Point> any_box() {
        const double west = pick(12) - 1.4;
        const double north = pick(12) - 1.4;
        return box(west, north, west + 1 + pick(6), north + 1 + pick(6));
    }

    std::mt19937 random;
};

// Against a count of cells by hand: grounds protect what has more than half of its cells on them, and nothing else; and
// whoever is protected without them is so with them.
TEST_F(PremisesOfHouses, protect_by_the_cells_of_their_kind) {
    const std::vector<std::string> kinds{"amenity=hospital", "amenity=school", "historic=yes"};
    for (unsigned seed = 0; seed < 40; ++seed) {
        SCOPED_TRACE(seed);
        RandomTown random(seed);
        OsmDrawing town(town_window);
        town.area("building=yes", box(-0.4, -0.4, 0.4, 0.4));
        for (int i = 1 + random.pick(6); i > 0; --i) {
            town.area(random.pick(4) == 0 ? "building=church" : "building=yes", random.any_box());
        }
        const geotiff::LabelTiff without = import(town).tiff;
        std::vector<std::vector<std::vector<Point>>> grounds(kinds.size());
        for (int i = random.pick(6); i > 0; --i) {
            const int kind = random.pick(int(kinds.size()));
            grounds[std::size_t(kind)].push_back(random.any_box());
            town.area(kinds[std::size_t(kind)], grounds[std::size_t(kind)].back());
        }
        const geotiff::LabelTiff with = import(town).tiff;
        ASSERT_TRUE(std::ranges::equal(with.map.labels(), without.map.labels()));
        for (const Obstacle& o : with.map.obstacles()) {
            bool expected = !without.map.obstacle(o.id).destructible;
            for (const auto& boxes : grounds) {
                std::uint32_t inside = 0;
                for (Cell c; c.y < town_side; ++c.y) {
                    for (c.x = 0; c.x < town_side; ++c.x) {
                        const bool within = std::ranges::any_of(boxes, [&](const std::vector<Point>& box) {
                            return c.x > box[0].x && c.x < box[2].x && c.y > box[0].y && c.y < box[2].y;
                        });
                        if (within && with.map.obstacle_at(c) == o.id) ++inside;
                    }
                }
                expected = expected || 2 * inside > o.cells;
            }
            EXPECT_EQ(!o.destructible, expected) << o.id.value;
        }
    }
}

}  // namespace
}  // namespace waybreaker::city
