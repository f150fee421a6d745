// What an extract of map data covers, and where it is built up.
#include "city/extract.hpp"

#include <cpl_vsi.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <numeric>

#include "city/osm_drawing.hpp"
#include "input_error.hpp"
#include "temporary_folder.hpp"

namespace waybreaker::city {
namespace {

class ExtractTest : public TemporaryFolder {
  protected:
    Extract extract_of(const OsmDrawing& drawing) const { return extract_of(drawing.xml()); }
    Extract extract_of(const std::string& xml) const {
        put("city.osm", xml);
        return read_extract(path("city.osm"));
    }
};

// 6 x 6 km, in cells of 10 m.
const ImportOptions country{.longitude = 9, .latitude = 50, .size = 6000, .cell = 10};
constexpr double degree_east = 71'700;  // metres, about there
constexpr double degree_north = 111'200;

void house(OsmDrawing& drawing, double x, double y, double side = 2) {
    drawing.area("building=yes", {{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}});
}

// Houses here and there, and a town of 1 km around a point.
OsmDrawing scattered_around(double x, double y) {
    OsmDrawing drawing = OsmDrawing(country).without_bounds();
    for (int i = 0; i < 30; ++i) {
        for (int j = 0; j < 30; ++j) house(drawing, 5 + 20 * i, 5 + 20 * j);
    }
    for (int i = -5; i < 5; ++i) {
        for (int j = -5; j < 5; ++j) house(drawing, x + 10 * i, y + 10 * j, 6);
    }
    return drawing;
}

TEST_F(ExtractTest, TheDensestSquareIsTheTown) {
    for (const auto& [x, y] : {std::pair{150.0, 420.0}, {480.0, 90.0}, {300.0, 300.0}}) {
        const Extract extract = extract_of(scattered_around(x, y));
        EXPECT_EQ(extract.buildings, 1000U);
        EXPECT_NEAR(extract.side, 1202.4, 1e-9);
        const auto [longitude, latitude] = geotiff::ToLonLat(import_window(country).georeference)(x, y);
        EXPECT_NEAR(extract.densest[0], longitude, 200 / degree_east);
        EXPECT_NEAR(extract.densest[1], latitude, 200 / degree_north);
    }
}

TEST_F(ExtractTest, TheDensestSquareIsWithinTheData) {
    for (int last = 250; last < 350; last += 9) {
        OsmDrawing drawing = OsmDrawing(country).without_bounds();
        for (int i = 0; i < 10; ++i) {
            for (int j = 0; j < 10; ++j) house(drawing, 10 * i, 10 * j, 6);
        }
        house(drawing, 590, last);
        const Extract extract = extract_of(drawing);
        const auto [west, south, east, north] = extract.bounds;
        EXPECT_GE(extract.densest[0] - west, (extract.side / 2 - 2) / degree_east) << last;
        EXPECT_GE(north - extract.densest[1], (extract.side / 2 - 2) / degree_north) << last;
    }
}

TEST_F(ExtractTest, SharesAddUpToTheAreaOfTheBuildings) {
    const Extract extract = extract_of(scattered_around(150, 420));
    EXPECT_EQ(extract.built.size(), std::size_t(extract.columns) * std::size_t(extract.rows));
    EXPECT_EQ(std::max(extract.columns, extract.rows), 64);
    const auto& [west, south, east, north] = extract.bounds;
    const double part = (east - west) * degree_east / extract.columns * (north - south) * degree_north / extract.rows;
    const double shares = std::accumulate(extract.built.begin(), extract.built.end(), 0.0);
    const double area = 900 * 20 * 20 + 100 * 60 * 60;
    EXPECT_NEAR(shares * part, area, 0.05 * area);
    EXPECT_TRUE(std::ranges::all_of(extract.built, [](double share) { return share >= 0 && share <= 1; }));
}

TEST_F(ExtractTest, CoversWhatTheSourceStates) {
    OsmDrawing drawing = OsmDrawing(country).without_bounds();
    house(drawing, 300, 300);
    std::string xml = drawing.xml();
    xml.insert(xml.find('\n') + 1, "<bounds minlat='49.98' minlon='8.9' maxlat='50.03' maxlon='9.04'/>\n");
    const Extract stated = extract_of(xml);
    EXPECT_EQ(stated.bounds, (std::array<double, 4>{8.9, 49.98, 9.04, 50.03}));
    EXPECT_EQ(stated.columns, 64);
    EXPECT_LT(stated.rows, 64);
    // Only around the one house where nothing is stated.
    const Extract found = extract_of(drawing);
    EXPECT_NEAR((found.bounds[2] - found.bounds[0]) * degree_east, 0, 1);
    EXPECT_GT(found.side, 0);
    EXPECT_NEAR(found.densest[0], (found.bounds[0] + found.bounds[2]) / 2, 1e-5);
}

TEST_F(ExtractTest, NamesPlacesByTheirImportance) {
    OsmDrawing drawing = OsmDrawing(country).without_bounds();
    drawing.point("place=village|name=Au", {100, 100});
    drawing.point("place=town|name=Stadt", {300, 200});
    drawing.point("place=town", {310, 200});
    drawing.point("place=farm|name=Hof", {320, 200});
    drawing.point("place=suburb|name=Vorstadt", {290, 200});
    house(drawing, 300, 300);
    const std::vector<NamedPlace> places = extract_of(drawing).places;
    ASSERT_EQ(places.size(), 3U);
    EXPECT_EQ(places[0].name, "Stadt");
    EXPECT_EQ(places[1].name, "Vorstadt");
    EXPECT_EQ(places[2].name, "Au");
    const auto at = geotiff::ToLonLat(import_window(country).georeference)(300, 200);
    EXPECT_NEAR(places[0].at[0], at[0], 1e-6);
    EXPECT_NEAR(places[0].at[1], at[1], 1e-6);
}

TEST_F(ExtractTest, WhatCannotBeImportedHasNoExtract) {
    OsmDrawing drawing = OsmDrawing(country).without_bounds();
    drawing.area("natural=water", {{1, 1}, {9, 1}, {9, 9}});
    EXPECT_NE(input_error([&] { extract_of(drawing); }).find("has no buildings"), std::string::npos);
    EXPECT_NE(input_error([&] { extract_of("not a map"); }).find("cannot be read as map data"), std::string::npos);
}

// GeoJSON of a building with these coordinates.
std::string building(const std::string& ring) {
    return R"({"type":"Feature","properties":{"building":"yes"},"geometry":{"type":"Polygon","coordinates":[[)" + ring +
           "]]}}";
}

TEST_F(ExtractTest, CoordinatesAreDegrees) {
    const auto refused = [this](const std::string& ring) {
        put("town.geojson", building(ring));
        return input_error([&] { read_extract(path("town.geojson")); });
    };
    for (const char* const ring :
         {"[1e308,1],[-1e308,2],[3,3],[1e308,1]", "[392000,5820000],[392020,5820000],[392020,5820020],[392000,5820000]",
          "[1,95],[2,95],[2,96],[1,95]"}) {
        const std::string error = refused(ring);
        EXPECT_NE(error.find("town.geojson: its coordinates are not longitude and latitude"), std::string::npos)
            << ring << ": " << error;
    }
    EXPECT_NE(refused("[392000,5820000],[392020,5820000],[392020,5820020],[392000,5820000]").find("ogr2ogr -s_srs"),
              std::string::npos);
    // Beyond all numbers there is no shape.
    EXPECT_NE(refused("[1e400,1],[2,2],[3,3],[1e400,1]").find("has no buildings"), std::string::npos);
    // Fiji.
    put("town.geojson", building("[179.9,-17],[180.1,-17],[180.1,-16.9],[179.9,-17]"));
    EXPECT_EQ(read_extract(path("town.geojson")).buildings, 1U);
}

TEST_F(ExtractTest, OtherThingsThatLieNowhereOnEarthDoNotMatter) {
    const auto with_point_at = [this](const std::string& longitude) {
        put("town.geojson", R"({"type":"FeatureCollection","features":[)" + building("[1,1],[2,1],[2,2],[1,1]") +
                                R"(,{"type":"Feature","properties":{},"geometry":{"type":"Point","coordinates":[)" +
                                longitude + ",1]}}]}");
    };
    for (const char* const longitude : {"1000", "1e308"}) {
        with_point_at(longitude);
        EXPECT_EQ(read_extract(path("town.geojson")).bounds, (std::array<double, 4>{1, 1, 2, 2})) << longitude;
    }
}

TEST_F(ExtractTest, CountsOnceWhatTheSourceHasTwice) {
    OsmDrawing drawing = OsmDrawing(country).without_bounds();
    for (int i = 0; i < 40; ++i) house(drawing, 10 * i, 300);
    std::string xml = drawing.xml();
    // What two queries of Overpass in one give.
    const std::size_t node = xml.find("<node");
    const std::size_t end = xml.find('\n', node);
    std::string twice = xml;
    twice.insert(end + 1, xml.substr(node, end + 1 - node));
    const std::size_t way = twice.find("<way");
    const std::size_t after = twice.find('\n', way);
    twice.insert(after + 1, twice.substr(way, after + 1 - way));
    EXPECT_EQ(extract_of(twice).buildings, 40U);
}

TEST_F(ExtractTest, SaysInWordsWhatTheReaderStumblesOver) {
    OsmDrawing drawing(country);
    for (int i = 0; i < 40; ++i) house(drawing, 10 * i, 300);
    const std::string xml = drawing.xml();
    const std::string packed = path("cut.osm.gz");
    VSILFILE* file = VSIFOpenL(("/vsigzip/" + packed).c_str(), "wb");
    ASSERT_NE(file, nullptr);
    VSIFWriteL(xml.data(), 1, xml.size(), file);
    VSIFCloseL(file);
    std::filesystem::resize_file(packed, std::filesystem::file_size(packed) / 2);
    const std::string cut = input_error([&] { read_extract(packed); });
    EXPECT_NE(cut.find("its gzip data ends too early"), std::string::npos) << cut;
    EXPECT_EQ(cut.find(".cpp"), std::string::npos) << cut;
}

}  // namespace
}  // namespace waybreaker::city
