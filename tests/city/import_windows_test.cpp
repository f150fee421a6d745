// Windows of an import, what counts in them as a building, and what is refused.
#include <fmt/format.h>
#include <gdal_priv.h>
#include <gdal_utils.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>

#include "city/city_import.hpp"
#include "city/drawn_city.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::city {
namespace {

TEST(CityImport, rounds_the_window_to_whole_cells) {
    const Source source("scene.geojson", geojson(scene()));
    EXPECT_EQ(import_city(source.path(), {13.4, 52.52, 1202.4, 2.4}).tiff.map.width(), 501);
    EXPECT_EQ(import_city(source.path(), {13.4, 52.52, 1200, 2.4}).tiff.map.width(), 500);
    EXPECT_EQ(import_city(source.path(), {13.4, 52.52, 119, 10}).tiff.map.height(), 12);
}

TEST(CityImport, works_across_the_date_line_and_the_equator) {
    const Source source("fiji.geojson", R"({"type":"Polygon","coordinates":[[[179.9995,-0.0005],[179.9999,-0.0005],)"
                                        R"([179.9999,0.0005],[179.9995,0.0005],[179.9995,-0.0005]]]})");
    const ImportReport report = import_city(source.path(), {.longitude = 180, .latitude = 0, .size = 200, .cell = 10});
    // 0.0004 by 0.001 degrees of a sphere of 40 000 km.
    EXPECT_NEAR(report.area, 44.5 * 110.6, 20);
    EXPECT_EQ(geotiff::crs_name(*report.tiff.georeference), "WGS 84 / UTM zone 60N");
}

TEST(CityImport, takes_a_box_across_the_date_line) {
    const Source source("fiji.geojson",
                        R"({"type":"MultiPolygon","coordinates":[)"
                        R"([[[179.9995,-17.0005],[180,-17.0005],[180,-17],[179.9995,-17],[179.9995,-17.0005]]],)"
                        R"([[[-180,-17.0005],[-179.9995,-17.0005],[-179.9995,-17],[-180,-17],[-180,-17.0005]]]]})");
    const ImportReport report = import_city(
        source.path(), {.cell = 5, .box = std::array{179.999, -17.001, -179.999, -16.9995}, .profile = Profile::paper});
    EXPECT_NEAR(report.tiff.map.width() * 5, 213, 10);
    EXPECT_NEAR(report.area, 0.001 * 106470 * 0.0005 * 110650, 20);
    const auto box = geotiff::lon_lat_box(*report.tiff.georeference, report.tiff.map.width(), report.tiff.map.height());
    ASSERT_TRUE(box);
    EXPECT_NEAR(box->at(0), 179.999, 1e-4);  // west is above east: RFC 7946, section 5.2
    EXPECT_NEAR(box->at(1), -17.001, 1e-4);
    EXPECT_NEAR(box->at(2), -179.999, 1e-4);
    EXPECT_NEAR(box->at(3), -16.9995, 1e-4);
}

std::string square_geojson(const std::string& building, const char* corner = "[13.4001,52.5200]") {
    return R"({"type":"Feature","properties":{"building":)" + building +
           R"(},"geometry":{"type":"Polygon","coordinates":[[[13.3999,52.5199],)" + corner +
           R"(,[13.4001,52.5201],[13.3999,52.5201],[13.3999,52.5199]]]}})";
}

std::string collection(const std::vector<std::string>& features) {
    return fmt::format(R"({{"type":"FeatureCollection","features":[{}]}})", fmt::join(features, ","));
}

TEST(CityImport, takes_what_denies_being_a_building_for_none) {
    const auto buildings = [](const std::string& value) {
        const Source source("one.geojson", collection({square_geojson(value), square_geojson(value)}));
        try {
            return import_city(source.path(), window).buildings;
        } catch (const InputError&) {
            return std::size_t{0};
        }
    };
    for (const char* none : {"false", "0", "\"no\"", "\"No\"", "\"false\"", "\"False\"", "\"0\"", "null"}) {
        EXPECT_EQ(buildings(none), 0U) << none;
    }
    for (const char* one : {"true", "1", "\"yes\"", "\"none of these\""}) EXPECT_EQ(buildings(one), 2U) << one;
}

TEST(CityImport, counts_what_has_no_coordinates) {
    const auto notes = [](const std::vector<std::string>& more) {
        std::vector<std::string> features{square_geojson("true")};
        features.insert(features.end(), more.begin(), more.end());
        const Source source("gaps.geojson", collection(features));
        const ImportReport report = import_city(source.path(), window);
        EXPECT_EQ(report.buildings, 1U);
        std::vector<std::string> found;
        for (const std::string& note : report.notes) {
            if (note.find("coordinates") != std::string::npos) found.push_back(note);
        }
        return found;
    };
    const std::string nowhere = R"({"type":"Feature","properties":{"building":"yes"},"geometry":null})";
    const std::string nan = square_geojson("true", "[NaN,52.5200]");
    const std::vector<std::string> one{"1 feature is left out: it has no coordinates, or such as are no numbers"};
    EXPECT_EQ(notes({}), std::vector<std::string>{});
    EXPECT_EQ(notes({nowhere}), one);
    EXPECT_EQ(notes({nan}), one);
    EXPECT_EQ(notes({R"({"type":"Feature","properties":{"building":"no"},"geometry":null})"}),
              std::vector<std::string>{});
    EXPECT_EQ(notes({nan, nowhere, nan}),
              std::vector<std::string>{"3 features are left out: they have no coordinates, or such as are no numbers"});
}

void expect_refusal(const std::string& source, const ImportOptions& options, const std::string& message) {
    try {
        import_city(source, options);
        ADD_FAILURE() << "was imported: " << message;
    } catch (const InputError& error) {
        const std::string said = error.what();
        EXPECT_NE(said.find(message), std::string::npos) << said;
        EXPECT_EQ(said.find('\n'), std::string::npos) << said;
    }
}

TEST(CityImport, refuses_windows_that_cannot_be) {
    const Source source("scene.geojson", geojson(scene()));
    const double nan = std::nan("");
    const auto expect = [&](ImportOptions options, const char* message) {
        expect_refusal(source.path(), options, message);
    };
    expect({181, 52, 120, 10}, "center 181,52");
    expect({13, 85, 120, 10}, "center 13,85");
    expect({nan, 52, 120, 10}, "center");
    expect({13, 52, 120, 0}, "cell 0");
    expect({13, 52, 120, -1}, "cell -1");
    expect({13, 52, 120, nan}, "cell nan");
    expect({13, 52, 0, 10}, "size 0");
    expect({13, 52, nan, 10}, "size nan");
    expect({13, 52, 1e300, 10}, "size");
    expect({13, 52, 16385, 1}, "size 16385");
    expect({13, 52, 200000, 100}, "size 200000");
    expect({.box = std::array{9.0, 50.0, 8.0, 51.0}}, "west must be below east, but for a box across 180 degrees");
    expect({.box = std::array{9.0, 51.0, 9.1, 50.0}}, "south below north");
}

TEST(CityImport, refuses_sources_without_buildings_and_says_why) {
    expect_refusal("/nowhere/city.osm.pbf", window, "/nowhere/city.osm.pbf: no such file");
    const auto expect = [](const char* name, const std::string& text, const char* message) {
        SCOPED_TRACE(name);
        const Source source(name, text);
        expect_refusal(source.path(), window, message);
        expect_refusal(source.path(), window, name);
    };
    expect("empty.osm.pbf", "", "is empty: has the download failed?");
    expect("busy.osm", "<!DOCTYPE html><html><body>429", "is a web page (HTML): has the download failed?");
    expect("error.geojson", R"({"error": "no such file"})", R"(It begins with '{"error": "no such file"}')");
    expect("overpass.json", R"({"generator":"Overpass API","elements":[]})",
           "ask for XML: begin the query with [out:xml]");
    expect("buildings.zip", "PK\x03\x04 etc", "is a ZIP archive: unpack it");
    expect("buildings.parquet", "PAR1 etc", "is Parquet");
    expect("city.o5c", "\xff\xe0\x04o5c2", "osmium apply-changes");
    expect("yard.map", "type octile\nheight 1\n", "is a MovingAI map, not map data with outlines");
    expect("junk.osm.pbf", std::string("\0\0\0\x0d\x0a\x09OSMHeader\x18\x7f", 17) + std::string(300, '\xfe'), "");
    expect("junk.osm.gz", "\x1f\x8b junk", "");
    expect("table.csv", "lon,lat\n1,2\n", "has no polygons");
    expect("lines.geojson", R"({"type":"LineString","coordinates":[[13.4,52.5],[13.5,52.5]]})", "has no polygons");
    expect("none.osm", "<osm version=\"0.6\"></osm>", "nor anywhere else");
    const std::string cut = osm_xml(scene());
    expect("cut.osm", cut.substr(0, cut.size() / 2), "is damaged or cut short");
    const Source source("scene.osm", osm_xml(scene()));
    ImportOptions elsewhere = window;
    elsewhere.longitude = 14;
    // Corners of the outermost of them, 60 m west of the window's centre and so on.
    expect_refusal(source.path(), elsewhere, "its buildings lie between 13.3");
}

}  // namespace
}  // namespace waybreaker::city
