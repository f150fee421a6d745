// What is an obstacle, what may go and what that costs, by tags; windows by their edges, and many of them at once.
#include "city/obstacle_choice.hpp"

#include <fmt/format.h>
#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include <cmath>
#include <map>

#include "city/city_import.hpp"
#include "city/feature_tags.hpp"
#include "input_error.hpp"
#include "temporary_folder.hpp"
#include "waybreaker/error.hpp"
#include "waybreaker/plan.hpp"

namespace waybreaker::city {
namespace {

constexpr double cell = 10;
const ImportOptions window{.longitude = 9, .latitude = 50, .size = 120, .cell = cell, .section = 0};

struct Corner {
    double column;  // in cells, from the window's upper-left corner
    double row;
};

// On the middle meridian of its zone UTM's grid runs with the meridians; these are its metres a degree there.
std::pair<double, double> lon_lat(Corner c) {
    return {9 + (c.column - 6) * cell / 71667, 50 + (6 - c.row) * cell / 111184};
}

std::vector<Corner> rectangle(double west, double north, double east, double south) {
    return {{west, north}, {east, north}, {east, south}, {west, south}, {west, north}};
}

// An OpenStreetMap file, way by way.
class OsmText {
  public:
    OsmText& way(int id, const std::vector<Corner>& corners, const std::map<std::string, std::string>& tags) {
        ways_ += fmt::format("<way id=\"{}\">", id);
        const bool closed =
            corners.front().column == corners.back().column && corners.front().row == corners.back().row;
        const int first = next_;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const bool last = closed && i + 1 == corners.size();
            ways_ += fmt::format("<nd ref=\"{}\"/>", last ? first : next_);
            if (last) break;
            const auto [lon, lat] = lon_lat(corners[i]);
            nodes_ += fmt::format("<node id=\"{}\" lat=\"{:.7f}\" lon=\"{:.7f}\"/>\n", next_++, lat, lon);
        }
        for (const auto& [key, value] : tags) ways_ += fmt::format("<tag k=\"{}\" v=\"{}\"/>", key, value);
        ways_ += "</way>\n";
        return *this;
    }
    std::string text() const {
        return "<?xml version=\"1.0\"?>\n<osm version=\"0.6\">\n"
               "<bounds minlat=\"49.99\" minlon=\"8.99\" maxlat=\"50.01\" maxlon=\"9.01\"/>\n" +
               nodes_ + ways_ + "</osm>\n";
    }

  private:
    std::string nodes_;
    std::string ways_;
    int next_ = 1000;
};

class ObstacleChoices : public TemporaryFolder {
  protected:
    std::string source_ = put(
        "town.osm", OsmText()
                        .way(11, rectangle(1.1, 1.1, 2.9, 2.9), {{"building", "yes"}, {"building:levels", "5 or so"}})
                        .way(12, rectangle(4.1, 1.1, 5.9, 2.9), {{"building", "church"}})
                        .way(13, {{1.2, 6.5}, {7.8, 6.5}}, {{"barrier", "wall"}, {"minutes", "2.5"}})
                        .way(14, rectangle(9.1, 8.1, 10.9, 10.9), {{"natural", "water"}})
                        .way(15, {{7.5, 0.2}, {7.5, 4.8}}, {{"barrier", "fence"}})
                        .way(16, rectangle(9.1, 1.1, 10.9, 2.9), {{"leisure", "park"}})
                        .text());

    ImportReport import(const ObstacleChoice& choice) const {
        ImportOptions options = window;
        options.choice = choice;
        return import_city(source_, options);
    }
};

// A letter for each source id.
std::string picture(const Map& map) {
    std::string text;
    for (Cell c; c.y < map.height(); ++c.y) {
        for (c.x = 0; c.x < map.width(); ++c.x) {
            const ObstacleId id = map.obstacle_at(c);
            text += id ? char('A' + map.obstacle(id).source_id - 11) : '.';
        }
        text += '\n';
    }
    return text;
}

const Obstacle& by_source(const Map& map, std::int64_t source_id) {
    for (const Obstacle& obstacle : map.obstacles()) {
        if (obstacle.source_id == source_id) return obstacle;
    }
    throw std::out_of_range("no such obstacle");
}

TEST_F(ObstacleChoices, AreBuildingsByDefault) {
    ImportOptions options = window;
    options.profile = Profile::paper;
    const ImportReport paper = import_city(source_, options);
    EXPECT_EQ(paper.buildings, 2U);
    EXPECT_EQ(picture(paper.tiff.map), picture(import({.obstacles = {{.key = "building"}}}).tiff.map));
}

TEST_F(ObstacleChoices, CanBeWallsAndWaters) {
    const ObstacleChoice choice{
        .obstacles = {{"building", {}}, {"barrier", {"wall", "hedge"}}, {"natural", {"water"}}}};
    EXPECT_EQ(picture(import(choice).tiff.map),
              "............\n"
              ".AA.BB......\n"
              ".AA.BB......\n"
              "............\n"
              "............\n"
              "............\n"
              ".CCCCCCC....\n"
              "............\n"
              ".........DD.\n"
              ".........DD.\n"
              ".........DD.\n"
              "............\n");
    EXPECT_EQ(import({.obstacles = {{"barrier", {}}}}).buildings, 2U);
    EXPECT_EQ(import({.obstacles = {{"building", {"church"}}}}).buildings, 1U);
    EXPECT_EQ(import({.obstacles = {{"*", {}}}}).buildings, 6U);
    const double thick = import({.obstacles = {{"barrier", {"wall"}}}, .wall_width = 20}).area;
    EXPECT_NEAR(thick, 66 * 20 + 10 * 10 * 3.14, 10);
}

// No gap lets a disc through, however the wall runs.
TEST_F(ObstacleChoices, WallsHaveNoGaps) {
    for (int degrees = 0; degrees < 180; degrees += 7) {
        const double x = 5 * std::cos(degrees * 3.14159 / 180);
        const double y = 5 * std::sin(degrees * 3.14159 / 180);
        const std::string path =
            put("wall.osm", OsmText().way(1, {{6 - x, 6 - y}, {6 + x, 6 + y}}, {{"barrier", "wall"}}).text());
        ImportOptions options = window;
        options.cell = 3;
        options.choice.obstacles = {{"barrier", {}}};
        const Map map = import_city(path, options).tiff.map;
        EXPECT_EQ(Map(Grid(map.grid()), Connectivity::eight).obstacles().size(), 1U) << degrees;
    }
}

TEST_F(ObstacleChoices, SayWhatCanBeDestroyed) {
    const std::vector<TagFilter> all{{"building", {}}, {"barrier", {}}, {"natural", {}}};
    const Map some = import({.obstacles = all, .destructible = {{"building", {}}, {"barrier", {"wall"}}}}).tiff.map;
    EXPECT_TRUE(by_source(some, 12).destructible);
    EXPECT_TRUE(by_source(some, 13).destructible);
    EXPECT_FALSE(by_source(some, 14).destructible);
    EXPECT_FALSE(by_source(some, 15).destructible);
    const Map others = import({.obstacles = all,
                               .destructible = {{"building", {}}},
                               .protect = {{"building", {"church"}}, {"natural", {}}}})
                           .tiff.map;
    EXPECT_TRUE(by_source(others, 11).destructible);
    EXPECT_FALSE(by_source(others, 12).destructible);
    EXPECT_FALSE(by_source(others, 13).destructible);
}

TEST_F(ObstacleChoices, SayWhatTheyCostAndTheFileKeepsIt) {
    const ObstacleChoice choice{.obstacles = {{"building", {}}, {"barrier", {"wall"}}},
                                .weight = {"building:levels", 2},
                                .breach_time = {"minutes", 1}};
    const geotiff::LabelTiff made = import(choice).tiff;
    for (const Map& map : {made.map, geotiff::read_label_tiff(geotiff::label_tiff_bytes(made), "town.tif").map}) {
        EXPECT_EQ(by_source(map, 11).weight, 10);
        EXPECT_EQ(by_source(map, 12).weight, 1);
        EXPECT_EQ(by_source(map, 11).breach_time, 0);
        EXPECT_EQ(by_source(map, 13).breach_time, 2.5);
        EXPECT_EQ(BreachTime({.per_obstacle = 1, .per_cell = 0}).of(by_source(map, 13)), 3.5);
    }
    const Map by_area = import({.obstacles = {{"building", {}}}, .weight = {"area", 0.01}}).tiff.map;
    EXPECT_NEAR(by_source(by_area, 11).weight, 3.24, 0.01);
}

TEST_F(ObstacleChoices, AddUpWhereTheyTouch) {
    const std::string path = put("row.osm", OsmText()
                                                .way(21, rectangle(1.1, 1.1, 3, 2.9), {{"building", "yes"}, {"w", "2"}})
                                                .way(22, rectangle(3, 1.1, 3.9, 2.9), {{"building", "no"}})
                                                .way(23, rectangle(3, 1.1, 7.9, 2.9), {{"building", "yes"}, {"w", "4"}})
                                                .text());
    ImportOptions options = window;
    options.merge_touching = true;
    options.choice.protect = {{"w", {"2"}}};
    EXPECT_EQ(import_city(path, options).tiff.map.obstacles()[0].weight, 1);
    options.choice.weight.of = "w";
    const Map map = import_city(path, options).tiff.map;
    ASSERT_EQ(map.obstacles().size(), 1U);
    EXPECT_EQ(map.obstacles()[0].weight, 6);
    EXPECT_EQ(map.obstacles()[0].source_id, 23);
    EXPECT_FALSE(map.obstacles()[0].destructible);
}

TEST_F(ObstacleChoices, AreCutOutByTheEdgesOfABox) {
    const auto [west, north] = lon_lat({0, 0});
    const auto [east, south] = lon_lat({6, 4});
    ImportOptions options{.cell = cell, .section = 0};
    options.box = {west, south, east, north};
    const geotiff::LabelTiff tiff = import_city(source_, options).tiff;
    EXPECT_EQ(tiff.map.width(), 6);
    EXPECT_EQ(tiff.map.height(), 4);
    EXPECT_EQ(picture(tiff.map), "......\n.AA.BB\n.AA.BB\n......\n");
    EXPECT_EQ(tiff.annotations.title, "town, 60 x 40 m around 8.9996, 50.0004");
    const auto [lon, lat] = geotiff::ToLonLat(*tiff.georeference)(-0.5, -0.5);
    EXPECT_NEAR(lon, west, 2e-6);
    EXPECT_NEAR(lat, north, 2e-6);
}

// Tiles are pieces of the whole; the one with the park is left out, and so is what is no whole tile.
TEST_F(ObstacleChoices, AreTheSameInTiles) {
    ImportOptions options = window;
    options.choice.obstacles = {{"building", {}}, {"natural", {}}};
    const Map whole = import_city(source_, options).tiff.map;
    std::map<std::pair<int, int>, Map> tiles;
    EXPECT_EQ(import_tiles(source_, options, 60,
                           [&](const ImportTile& tile) {
                               tiles.emplace(std::pair(tile.row, tile.column), tile.report.tiff.map);
                           }),
              4U);
    ASSERT_EQ(tiles.size(), 2U);
    for (const auto& [place, tile] : tiles) {
        ASSERT_EQ(tile.width(), 6);
        for (Cell c; c.y < 6; ++c.y) {
            for (c.x = 0; c.x < 6; ++c.x) {
                const ObstacleId here = tile.obstacle_at(c);
                const ObstacleId there = whole.obstacle_at({c.x + 6 * place.second, c.y + 6 * place.first});
                ASSERT_EQ(bool(here), bool(there));
                EXPECT_TRUE(!here || tile.obstacle(here).source_id == whole.obstacle(there).source_id);
            }
        }
    }
    EXPECT_EQ(import_tiles(source_, options, 50, [](const ImportTile&) {}), 4U);
    EXPECT_THROW(import_tiles(source_, options, 130, [](const ImportTile&) {}), InputError);
}

std::vector<std::string> filters_in(const std::string& text) {
    std::vector<std::string> texts;
    for (const TagFilter& filter : parse_tag_filters(text)) texts.push_back(filter.text());
    return texts;
}

TEST(TagFilters, AreKeysWithOrWithoutValues) {
    using Texts = std::vector<std::string>;
    EXPECT_EQ(filters_in("building"), Texts{"building"});
    EXPECT_EQ(filters_in("barrier=wall,fence"), Texts{"barrier=wall,fence"});
    EXPECT_EQ(filters_in("building,natural=water"), (Texts{"building", "natural=water"}));
    EXPECT_EQ(filters_in("building,man_made,natural=water,wood,barrier=wall,fence"),
              (Texts{"building", "man_made", "natural=water,wood", "barrier=wall,fence"}));
    EXPECT_TRUE(parse_tag_filters("building")[0].accepts("yes"));
    EXPECT_FALSE(parse_tag_filters("building")[0].accepts("no"));
    EXPECT_FALSE(parse_tag_filters("barrier=wall")[0].accepts("fence"));
    for (const char* bad : {"", "=", "=wall", "barrier=", "barrier=wall,", "a\"b", "a'b=c", ",", "building,",
                            ",building", "a=b,,c", "building,=water"}) {
        EXPECT_THROW(parse_tag_filters(bad), InputError) << bad;
    }
    // A building is hardly meant to be a kind of water.
    EXPECT_NE(input_error([] {
                  parse_tag_filters("natural=water,building");
              }).find("takes building for a value of 'natural'; put it first"),
              std::string::npos);
    EXPECT_LT(input_error([] { parse_tag_filters(std::string(100000, '=')); }).size(), 200U);
    EXPECT_LT(input_error([] { parse_quantity(std::string(100000, '*')); }).size(), 200U);
}

TEST(TagFilters, ReadQuantities) {
    EXPECT_EQ(parse_quantity("area").of, "area");
    EXPECT_EQ(parse_quantity("building:levels*0.5").factor, 0.5);
    for (const char* bad : {"", "*2", "area*", "area*x", "area*0", "area*-1", "area*inf", "area*1 "}) {
        EXPECT_THROW(parse_quantity(bad), InputError) << bad;
    }
}

// As ogr2ogr makes them of OpenStreetMap's data.
TEST(TagFilters, FindOtherTags) {
    GDALAllRegister();
    const GDALDatasetUniquePtr file(
        GetGDALDriverManager()->GetDriverByName("Memory")->Create("", 0, 0, 0, GDT_Unknown, nullptr));
    OGRLayer& layer = *file->CreateLayer("multipolygons");
    for (const char* name : {"NAME", "other_tags"}) {
        OGRFieldDefn field(name, OFTString);
        layer.CreateField(&field);
    }
    const auto tags_of = [&layer](const char* pairs) {
        OGRFeature feature(layer.GetLayerDefn());
        feature.SetField("NAME", "Barn");
        feature.SetField("other_tags", pairs);
        return FeatureTags(layer).all(feature);
    };
    const TagSet tags = tags_of(R"("height"=>"12 m","note"=>"a \"b\", \"levels\"=>\"9\"","levels"=>"3")");
    EXPECT_TRUE(tags.is("name", "Barn"));
    EXPECT_TRUE(tags.is("height", "12 m"));
    EXPECT_TRUE(tags.is("note", R"(a "b", "levels"=>"9")"));
    EXPECT_TRUE(tags.is("levels", "3"));
    EXPECT_EQ(tags.find("eight"), nullptr);
    EXPECT_TRUE(tags_of("\"a\"=>\"").is("a", ""));
}

}  // namespace
}  // namespace waybreaker::city
