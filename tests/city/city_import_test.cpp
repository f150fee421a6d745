// A scene drawn in cells, written as GeoJSON, OpenStreetMap XML and shapefile, must come back as the drawing.
#include "city/city_import.hpp"

#include <fmt/format.h>
#include <gdal_priv.h>
#include <gdal_utils.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>

#include "city/drawn_city.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::city {
namespace {

TEST(CityImport, draws_geojson) {
    const Source source("scene.geojson", geojson(scene()));
    const ImportReport report = import_city(source.path(), window);
    expect_scene(report);
    EXPECT_EQ(report.tiff.annotations.title, "scene, 120 m around 13.4000, 52.5200");
    EXPECT_EQ(geotiff::label_tiff_bytes(report.tiff),
              geotiff::label_tiff_bytes(import_city(source.path(), window).tiff));
}

TEST(CityImport, draws_openstreetmap_xml) {
    const Source source("scene.osm", osm_xml(scene()));
    expect_scene(import_city(source.path(), window));
}

TEST(CityImport, draws_gzipped_openstreetmap_and_leaves_nothing_behind) {
    const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "city_import_test";
    std::filesystem::remove_all(folder);
    std::filesystem::create_directory(folder);
    const std::string path = folder / "scene.osm.gz";
    const std::string text = osm_xml(scene());
    VSILFILE* file = VSIFOpenL(("/vsigzip/" + path).c_str(), "wb");
    VSIFWriteL(text.data(), 1, text.size(), file);
    VSIFCloseL(file);
    expect_scene(import_city(path, window));
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) names.push_back(entry.path().filename());
    EXPECT_EQ(names, std::vector<std::string>{"scene.osm.gz"});
    std::filesystem::remove_all(folder);
}

// Writes the scene to a shapefile in another coordinate system, leaving out what a shapefile of buildings does not
// hold.
TEST(CityImport, draws_a_shapefile_in_another_coordinate_system) {
    GDALAllRegister();
    const Source source("scene.geojson", geojson(scene()));
    for (const char* system : {"EPSG:3857", "EPSG:4258"}) {
        SCOPED_TRACE(system);
        CPLStringList arguments;
        for (const char* a : {"-f", "ESRI Shapefile", "-t_srs", system, "-select", "osm_id", "-where",
                              "building is not null and building <> 'no'"}) {
            arguments.AddString(a);
        }
        const std::string path = "/vsimem/city_import_test/shapes.shp";
        GDALVectorTranslateOptions* options = GDALVectorTranslateOptionsNew(arguments.List(), nullptr);
        GDALDatasetUniquePtr in(GDALDataset::Open(source.path().c_str(), GDAL_OF_VECTOR));
        GDALDatasetH in_handle = GDALDataset::ToHandle(in.get());
        GDALClose(GDALVectorTranslate(path.c_str(), nullptr, 1, &in_handle, options, nullptr));
        GDALVectorTranslateOptionsFree(options);
        expect_scene(import_city(path, window));
        in.reset(GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR | GDAL_OF_UPDATE));
        in->GetDriver()->Delete(path.c_str());
    }
}

TEST(CityImport, merges_touching_buildings) {
    ImportOptions merging = window;
    merging.merge_touching = true;
    merging.profile = Profile::paper;
    const Source source("scene.osm", osm_xml(scene()));
    const ImportReport report = import_city(source.path(), merging);
    EXPECT_EQ(picture(report.tiff.map),
              "............\n"
              ".AAAAA.MM.M.\n"
              ".A...A.MM...\n"
              ".A...A......\n"
              ".A...A......\n"
              ".AAAAA......\n"
              "...........E\n"
              ".TTTTT.....E\n"
              ".TTTT.......\n"
              "..TTT.......\n"
              "............\n"
              "............\n");
    EXPECT_EQ(report.tiff.map.obstacles().size(), 5U);  // the school's two parts are apart
    EXPECT_EQ(report.buildings, buildings_in_window);
}

// As the Empire State Building is drawn: its outline is also the outer way of a relation that is no building.
TEST(CityImport, keeps_a_building_whose_outline_serves_a_relation_too) {
    std::string text = osm_xml({{'T', 11, "building=yes", {{rectangle(1.1, 7.1, 3.9, 9.1)}}}});
    text.insert(text.rfind("</osm>"),
                "<relation id=\"7\"><member type=\"way\" ref=\"11\" role=\"outer\"/>"
                "<tag k=\"type\" v=\"multipolygon\"/><tag k=\"building:part\" v=\"yes\"/></relation>\n");
    const Source source("part.osm", text);
    const Map map = import_city(source.path(), window).tiff.map;
    ASSERT_EQ(map.obstacles().size(), 1U);
    EXPECT_EQ(map.obstacles().front().source_id, 11);
}

// And the other way round: a relation that says nothing itself speaks for its ways.
TEST(CityImport, knows_a_building_by_the_tags_of_its_outer_way) {
    const Polygon ring{rectangle(0.9, 0.9, 5.9, 5.9), rectangle(1.9, 1.9, 4.9, 4.9)};
    std::string text = osm_xml({{'A', -500, "note=x", {ring}}});
    const std::string tag = "<tag k=\"note\" v=\"x\"/>";
    text.erase(text.find(tag), tag.size());
    text.insert(text.find("</way>"), "<tag k=\"building\" v=\"yes\"/>");
    const Source source("old_style.osm", text);
    const Map map = import_city(source.path(), window).tiff.map;
    ASSERT_EQ(map.obstacles().size(), 1U);
    EXPECT_EQ(map.obstacles().front().cells, 16U);
}

TEST(CityImport, takes_every_polygon_where_nothing_says_building) {
    const Source source("plain.geojson", geojson({{'T', 11, "name=x", {{rectangle(1.1, 7.1, 3.9, 9.1)}}}}));
    EXPECT_EQ(import_city(source.path(), window).buildings, 1U);
}

TEST(CityImport, survives_a_building_that_crosses_itself) {
    const Source source("bow.geojson",
                        geojson({{'T', 11, "building=yes", {{{{8.1, 2.1}, {16, 8.1}, {16, 2.1}, {8.1, 8.1}}}}}}));
    const ImportReport report = import_city(source.path(), window);
    EXPECT_EQ(report.buildings, 1U);
    EXPECT_GT(report.tiff.map.obstacles().front().cells, 5U);
}

}  // namespace
}  // namespace waybreaker::city
