// Streets, water and green drawn in cells, written as map data, must come back where they were drawn.
#include "city/scenery.hpp"

#include <cpl_vsi.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

#include "city/city_import.hpp"
#include "city/osm_drawing.hpp"

namespace waybreaker::city {
namespace {

using Kind = site::Background::Kind;
using Shape = site::Background::Shape;
using Parts = std::vector<std::vector<Point>>;

// 40 x 40 cells of 2 m.
const ImportOptions window{.longitude = 13.4, .latitude = 52.52, .size = 80, .cell = 2, .section = 0};

class SceneryOf : public testing::Test {
  protected:
    ~SceneryOf() override { VSIRmdirRecursive("/vsimem/scenery_test"); }

    // A building is there so that there is something to import.
    static ImportReport import(OsmDrawing drawing, const ImportOptions& options = window) {
        drawing.area("building=yes", {{30, 30}, {36, 30}, {36, 36}, {30, 36}});
        return import_city(write("town.osm", drawing.xml()), options);
    }
    static std::string write(const std::string& name, const std::string& text) {
        std::string path = "/vsimem/scenery_test/" + name;
        VSILFILE* file = VSIFOpenL(path.c_str(), "wb");
        VSIFWriteL(text.data(), 1, text.size(), file);
        VSIFCloseL(file);
        return path;
    }
};

void expect_background(const site::Background& background, const std::vector<site::Background::Feature>& expected) {
    std::string seen;
    for (const site::Background::Feature& feature : background.features)
        seen += feature.type + " " + feature.name + "\n";
    ASSERT_EQ(background.features.size(), expected.size()) << seen;
    for (std::size_t i = 0; i < expected.size(); ++i) {
        const site::Background::Feature& feature = background.features[i];
        SCOPED_TRACE(feature.type + " " + feature.name);
        EXPECT_EQ(feature.kind, expected[i].kind);
        EXPECT_EQ(feature.type, expected[i].type);
        EXPECT_EQ(feature.name, expected[i].name);
        EXPECT_EQ(feature.shape, expected[i].shape);
        ASSERT_EQ(feature.parts.size(), expected[i].parts.size());
        for (std::size_t j = 0; j < feature.parts.size(); ++j) {
            std::vector<Point> part = feature.parts[j];
            const std::vector<Point>& drawn = expected[i].parts[j];
            ASSERT_EQ(part.size(), drawn.size());
            // Rings begin anywhere.
            const auto near_first = [&](const Point& p) { return distance(p, drawn.front()) < 0.05; };
            if (feature.shape == Shape::area) {
                std::rotate(part.begin(), std::find_if(part.begin(), part.end(), near_first), part.end());
            }
            for (std::size_t k = 0; k < part.size(); ++k) EXPECT_LT(distance(part[k], drawn[k]), 0.05);
        }
    }
}

TEST_F(SceneryOf, a_town_comes_back_as_it_was_drawn) {
    OsmDrawing town(window);
    town.way("highway=primary|name=High Street", {{2, 5}, {12, 5}})
        .way("highway=primary|name=High Street|lanes=3", {{12, 5}, {20, 9}, {60, 9}})
        .way("highway=residential", {{12, 5}, {12, 25}})
        .way("highway=footway|name=Poets&apos; Walk", {{1, 30}, {8, 30}})
        .way("railway=tram", {{3, 1}, {3, 38}})
        .way("waterway=river|name=Spree", {{-20, 20}, {10, 20}})
        .area("natural=water", {{25, 12}, {35, 12}, {35, 20}, {25, 20}})
        .area("leisure=park|name=Old Park", {{1, 32}, {9, 32}, {9, 38}, {1, 38}})
        .area("highway=pedestrian|area=yes|name=Market", {{14, 12}, {22, 12}, {22, 20}, {14, 20}})
        .point("place=square|name=Market", {18, 16})
        .point("place=suburb|name=Old Town", {5, 12});
    expect_background(import(town).tiff.annotations.background,
                      {{Kind::street, "primary", "High Street", Shape::line, {{{2, 5}, {12, 5}, {20, 9}, {39.5, 9}}}},
                       {Kind::street, "pedestrian", "Market", Shape::area, {{{14, 20}, {22, 20}, {22, 12}, {14, 12}}}},
                       {Kind::street, "residential", "", Shape::line, {{{12, 5}, {12, 25}}}},
                       {Kind::street, "footway", "Poets' Walk", Shape::line, {{{1, 30}, {8, 30}}}},
                       {Kind::rail, "tram", "", Shape::line, {{{3, 1}, {3, 38}}}},
                       {Kind::water, "river", "Spree", Shape::line, {{{-0.5, 20}, {10, 20}}}},
                       {Kind::water, "water", "", Shape::area, {{{25, 20}, {35, 20}, {35, 12}, {25, 12}}}},
                       {Kind::green, "park", "Old Park", Shape::area, {{{1, 38}, {9, 38}, {9, 32}, {1, 32}}}},
                       {Kind::place, "suburb", "Old Town", Shape::point, {{{5, 12}}}},
                       {Kind::place, "square", "Market", Shape::point, {{{18, 16}}}}});
}

TEST_F(SceneryOf, what_cannot_be_seen_is_left_out) {
    OsmDrawing town(window);
    town.way("highway=primary|tunnel=yes", {{2, 5}, {12, 5}})
        .way("highway=residential|tunnel=building_passage", {{2, 6}, {12, 6}})
        .way("railway=subway|tunnel=yes", {{2, 7}, {12, 7}})
        .way("railway=rail|service=yard", {{2, 8}, {12, 8}})
        .way("railway=abandoned", {{2, 9}, {12, 9}})
        .way("highway=footway|footway=sidewalk", {{2, 10}, {12, 10}})
        .way("highway=service", {{2, 11}, {12, 11}})
        .way("highway=construction|name=Some Day", {{2, 12}, {12, 12}})
        .way("highway=tertiary", {{-20, 4}, {-10, 8}})
        .way("highway=tertiary", {{5, 4}, {6.5, 4}})
        .area("landuse=grass", {{14, 12}, {16, 12}, {16, 14}, {14, 14}})
        .area("leisure=pitch", {{14, 12}, {22, 12}, {22, 20}, {14, 20}})
        .point("place=square", {18, 16})
        .point("amenity=cafe|name=Corner", {5, 12})
        .point("place=suburb|name=Elsewhere", {5, 62});
    expect_background(import(town).tiff.annotations.background, {});
}

TEST_F(SceneryOf, areas_of_one_name_are_one_where_they_overlap) {
    OsmDrawing town(window);
    town.area("leisure=park", {{2, 2}, {12, 2}, {12, 12}, {2, 12}})
        .area("leisure=park", {{7, 2}, {22, 2}, {22, 12}, {7, 12}});
    expect_background(import(town).tiff.annotations.background,
                      {{Kind::green, "park", "", Shape::area, {{{2, 12}, {22, 12}, {22, 2}, {2, 2}}}}});
}

TEST_F(SceneryOf, bends_below_half_a_cell_go) {
    OsmDrawing town(window);
    town.way("highway=primary", {{2, 5}, {6, 5.3}, {12, 5}, {15, 5.8}, {20, 5}});
    expect_background(import(town).tiff.annotations.background,
                      {{Kind::street, "primary", "", Shape::line, {{{2, 5}, {12, 5}, {15, 5.8}, {20, 5}}}}});
}

TEST_F(SceneryOf, a_place_is_named_once_where_it_can_be_seen) {
    OsmDrawing town(window);
    town.area("place=square|name=Market", {{14, 12}, {22, 12}, {22, 20}, {14, 20}})
        .point("place=square|name=Market", {17, 15})
        .area("place=square|name=Green", {{-40, 12}, {2, 12}, {2, 20}, {-40, 20}});
    const site::Background background = import(town).tiff.annotations.background;
    expect_background(background, {{Kind::place, "square", "Green", Shape::point, {{{0.75, 16}}}},
                                   {Kind::place, "square", "Market", Shape::point, {{{17, 15}}}}});
}

TEST_F(SceneryOf, tiles_is_for_each_its_own) {
    OsmDrawing town(window);
    town.way("highway=primary", {{2, 5}, {38, 5}})
        .area("building=yes", {{2, 8}, {6, 8}, {6, 12}, {2, 12}})
        .area("building=yes", {{22, 8}, {26, 8}, {26, 12}, {22, 12}});
    std::vector<site::Background> seen;
    import_tiles(write("town.osm", town.xml()), window, 40, [&](const ImportTile& tile) {
        EXPECT_EQ(tile.row, 0);
        seen.push_back(tile.report.tiff.annotations.background);
    });
    ASSERT_EQ(seen.size(), 2U);
    expect_background(seen[0], {{Kind::street, "primary", "", Shape::line, {{{2, 5}, {19.5, 5}}}}});
    expect_background(seen[1], {{Kind::street, "primary", "", Shape::line, {{{-0.5, 5}, {18, 5}}}}});
}

TEST_F(SceneryOf, geojson_is_found_by_its_attributes) {
    const site::Georeference place = import_window(window).georeference;
    const auto at = [&](double x, double y) {
        const auto [longitude, latitude] = geotiff::ToLonLat(place)(x, y);
        return fmt::format("[{:.8f},{:.8f}]", longitude, latitude);
    };
    const std::string text = fmt::format(
        R"({{"type":"FeatureCollection","features":[
{{"type":"Feature","properties":{{"building":"yes","name":"Hall"}},"geometry":{{"type":"Polygon","coordinates":[[{0},{1},{2},{0}]]}}}},
{{"type":"Feature","properties":{{"highway":"primary","name":"High Street"}},"geometry":{{"type":"MultiLineString","coordinates":[[{3},{4}]]}}}}
]}})",
        at(2, 2), at(12, 2), at(12, 12), at(5, 20), at(30, 20));
    const geotiff::LabelTiff tiff = import_city(write("town.geojson", text), window).tiff;
    expect_background(tiff.annotations.background,
                      {{Kind::street, "primary", "High Street", Shape::line, {{{5, 20}, {30, 20}}}}});
    EXPECT_EQ(tiff.annotations.names, (site::ObstacleNames{"", "Hall"}));
}

TEST_F(SceneryOf, nothing_is_kept_of_it_if_it_is_not_wanted) {
    ImportOptions options = window;
    options.background = false;
    options.names = false;
    const geotiff::LabelTiff tiff = import(OsmDrawing(window)
                                               .way("highway=primary", {{2, 5}, {12, 5}})
                                               .area("building=yes|name=Hall", {{2, 8}, {6, 8}, {6, 12}}),
                                           options)
                                        .tiff;
    EXPECT_EQ(tiff.annotations.background, site::Background{});
    EXPECT_EQ(tiff.annotations.names, site::ObstacleNames{});
}

using NamesOf = SceneryOf;

TEST_F(NamesOf, buildings_are_their_own_or_their_address) {
    OsmDrawing town(window);
    town.area("building=yes|name=Town Hall|addr:street=High Street|addr:housenumber=1",
              {{2, 2}, {6, 2}, {6, 6}, {2, 6}})
        .area("building=yes|addr:housename=The Cottage|addr:housenumber=2", {{12, 2}, {16, 2}, {16, 6}, {12, 6}})
        .area("building=yes|addr:street=High Street|addr:housenumber=3", {{22, 2}, {26, 2}, {26, 6}, {22, 6}})
        .area("building=yes|addr:housenumber=4", {{32, 2}, {36, 2}, {36, 6}, {32, 6}});
    EXPECT_EQ(import(town).tiff.annotations.names,
              (site::ObstacleNames{"", "Town Hall", "The Cottage", "High Street 3", "", ""}));
}

TEST_F(NamesOf, blocks_are_that_of_the_largest_part_that_has_one) {
    OsmDrawing town(window);
    town.area("building=yes", {{2, 2}, {12, 2}, {12, 12}, {2, 12}})
        .area("building=yes|name=Small", {{12, 2}, {14, 2}, {14, 12}, {12, 12}})
        .area("building=yes|name=Large", {{14, 2}, {18, 2}, {18, 12}, {14, 12}})
        .area("building=yes|name=Medium", {{18, 2}, {21, 2}, {21, 12}, {18, 12}});
    ImportOptions options = window;
    options.merge_touching = true;
    EXPECT_EQ(import(town, options).tiff.annotations.names, (site::ObstacleNames{"", "Large", ""}));
}

}  // namespace
}  // namespace waybreaker::city
