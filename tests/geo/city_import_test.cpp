// A scene drawn in cells, written as GeoJSON, OpenStreetMap XML and shapefile, must come back as the drawing.
#include "geo/city_import.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gdal_priv.h>
#include <gdal_utils.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>

#include "waybreaker/error.hpp"

namespace waybreaker::geo {
namespace {

constexpr int cells = 12;
const ImportOptions window{.longitude = 13.4, .latitude = 52.52, .size = 120, .cell = 10, .section = 0};

struct Corner {
    double column;  // in cells, from the window's upper-left corner
    double row;
};
using Ring = std::vector<Corner>;
using Polygon = std::vector<Ring>;  // outer ring, holes

Ring rectangle(double west, double north, double east, double south) {
    return {{west, north}, {east, north}, {east, south}, {west, south}};
}

struct Thing {
    char letter;                // in pictures; '-' is never seen there
    std::int64_t osm_id;        // relations are negative
    const char* tag;            // key=value
    std::vector<Polygon> area;  // more than one: a multipolygon
};

// Fractions keep every cell centre clear of every edge. All but the last four are buildings with a part in the window.
const std::vector<Thing>& scene() {
    static const std::vector<Thing> things{
        {'A', -500, "building=yes", {{rectangle(0.9, 0.9, 5.9, 5.9), rectangle(1.9, 1.9, 4.9, 4.9)}}},
        {'M', -510, "building=school", {{rectangle(7.1, 0.9, 8.9, 2.9)}, {rectangle(10.1, 0.9, 11.2, 1.9)}}},
        {'T', 11, "building=yes", {{rectangle(1.1, 7.1, 3.9, 9.1)}}},
        {'U', 12, "building=yes", {{rectangle(3.9, 7.1, 6.1, 8.1)}}},
        {'E', 13, "building=yes", {{rectangle(10.6, 6.1, 15, 8.1)}}},
        {'-', 15, "building=yes", {{rectangle(8.1, 10.6, 11.9, 11.4)}}},  // covers no cell centre
        {'V', 18, "building=yes", {{rectangle(2.1, 8.1, 4.9, 10.1)}}},    // partly under T
        {'-', 20, "building=no", {{rectangle(7.1, 8.1, 8.1, 9.1)}}},
        {'-', 21, "leisure=park", {{rectangle(7.1, 4.1, 9.1, 5.1)}}},
        {'-', 22, "building=yes", {{rectangle(20, 2, 22, 4)}}},
        {'-', 23, "building=yes", {{rectangle(-400, 2, -390, 400)}}},
    };
    return things;
}

constexpr std::size_t buildings_in_window = 7;
constexpr double area_in_window = 100 * (16 + 3.6 + 1.1 + 5.6 + 2.2 + 2.8 + 3.04 + 5.6);

const char* const drawing =
    "............\n"
    ".AAAAA.MM.M.\n"
    ".A...A.MM...\n"
    ".A...A......\n"
    ".A...A......\n"
    ".AAAAA......\n"
    "...........E\n"
    ".TTTUU.....E\n"
    ".TTTV.......\n"
    "..VVV.......\n"
    "............\n"
    "............\n";

// Longitude and latitude of a corner, by the way back: UTM zone 33N to WGS84.
class Site {
  public:
    Site() {
        OGRSpatialReference wgs84;
        OGRSpatialReference utm;
        wgs84.SetWellKnownGeogCS("WGS84");
        wgs84.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
        utm.importFromEPSG(32633);
        to_wgs84_.reset(OGRCreateCoordinateTransformation(&utm, &wgs84));
        const std::unique_ptr<OGRCoordinateTransformation> to_utm(OGRCreateCoordinateTransformation(&wgs84, &utm));
        east_ = window.longitude;
        north_ = window.latitude;
        to_utm->Transform(1, &east_, &north_);
    }
    std::pair<double, double> lon_lat(Corner c) const {
        double x = east_ + (c.column - cells / 2.0) * window.cell;
        double y = north_ - (c.row - cells / 2.0) * window.cell;
        to_wgs84_->Transform(1, &x, &y);
        return {x, y};
    }

  private:
    double east_ = 0;
    double north_ = 0;
    std::unique_ptr<OGRCoordinateTransformation> to_wgs84_;
};

// A file in GDAL's memory, as one would have it on disk.
class Source {
  public:
    Source(const std::string& name, const std::string& text) : path_("/vsimem/city_import_test/" + name) {
        VSILFILE* file = VSIFOpenL(path_.c_str(), "wb");
        VSIFWriteL(text.data(), 1, text.size(), file);
        VSIFCloseL(file);
    }
    ~Source() { VSIRmdirRecursive("/vsimem/city_import_test"); }
    const std::string& path() const { return path_; }

  private:
    std::string path_;
};

std::string geojson(const std::vector<Thing>& things) {
    const Site site;
    std::string features;
    for (const Thing& thing : things) {
        std::string polygons;
        for (const Polygon& polygon : thing.area) {
            std::string rings;
            for (Ring ring : polygon) {
                ring.push_back(ring.front());
                std::string corners;
                for (const Corner& corner : ring) {
                    const auto [lon, lat] = site.lon_lat(corner);
                    corners += fmt::format("{}[{:.9f},{:.9f}]", corners.empty() ? "" : ",", lon, lat);
                }
                rings += fmt::format("{}[{}]", rings.empty() ? "" : ",", corners);
            }
            polygons += fmt::format("{}[{}]", polygons.empty() ? "" : ",", rings);
        }
        const std::string tag = thing.tag;
        const std::size_t equals = tag.find('=');
        features += fmt::format(R"({}{{"type":"Feature","properties":{{"osm_id":{},"{}":"{}"}},)"
                                R"("geometry":{{"type":"MultiPolygon","coordinates":[{}]}}}})",
                                features.empty() ? "" : ",", thing.osm_id, tag.substr(0, equals),
                                tag.substr(equals + 1), polygons);
    }
    return fmt::format(R"({{"type":"FeatureCollection","features":[{}]}})", features);
}

// Ways for single rings; multipolygon relations, with untagged ways as members, for the rest.
std::string osm_xml(const std::vector<Thing>& things) {
    const Site site;
    std::string nodes;
    std::string ways;
    std::string relations;
    int next_id = 1000;
    const auto way = [&](std::int64_t id, const Ring& ring, const std::string& tag) {
        const int first = next_id;
        std::string members;
        for (const Corner& corner : ring) {
            const auto [lon, lat] = site.lon_lat(corner);
            nodes += fmt::format("<node id=\"{}\" lat=\"{:.7f}\" lon=\"{:.7f}\"/>\n", next_id, lat, lon);
            members += fmt::format("<nd ref=\"{}\"/>", next_id++);
        }
        ways += fmt::format("<way id=\"{}\">{}<nd ref=\"{}\"/>{}</way>\n", id, members, first, tag);
    };
    for (const Thing& thing : things) {
        const std::string text = thing.tag;
        const std::size_t equals = text.find('=');
        const std::string tag =
            fmt::format("<tag k=\"{}\" v=\"{}\"/>", text.substr(0, equals), text.substr(equals + 1));
        if (thing.osm_id > 0) {
            way(thing.osm_id, thing.area.at(0).at(0), tag);
            continue;
        }
        std::string members;
        for (const Polygon& polygon : thing.area) {
            for (std::size_t i = 0; i < polygon.size(); ++i) {
                const int id = next_id++;
                way(id, polygon[i], "");
                members += fmt::format("<member type=\"way\" ref=\"{}\" role=\"{}\"/>", id, i == 0 ? "outer" : "inner");
            }
        }
        relations += fmt::format("<relation id=\"{}\">{}<tag k=\"type\" v=\"multipolygon\"/>{}</relation>\n",
                                 -thing.osm_id, members, tag);
    }
    return "<?xml version=\"1.0\"?>\n<osm version=\"0.6\">\n" + nodes + ways + relations + "</osm>\n";
}

std::string picture(const Map& map) {
    std::map<std::int64_t, char> letters;
    for (const Thing& thing : scene()) letters[thing.osm_id] = thing.letter;
    std::string text;
    for (int y = 0; y < map.height(); ++y) {
        for (int x = 0; x < map.width(); ++x) {
            const ObstacleId id = map.obstacle_at({x, y});
            text += id ? letters.at(map.obstacle(id).source_id) : '.';
        }
        text += '\n';
    }
    return text;
}

void expect_scene(const ImportReport& report) {
    EXPECT_EQ(picture(report.tiff.map), drawing);
    EXPECT_EQ(report.tiff.map.obstacles().size(), 6U);
    EXPECT_EQ(report.buildings, buildings_in_window);
    EXPECT_NEAR(report.area, area_in_window, 2);  // corners are rounded to a centimetre in OpenStreetMap's own format
    EXPECT_EQ(report.tiff.attribution, "(c) OpenStreetMap contributors, ODbL 1.0");
    EXPECT_EQ(crs_name(*report.tiff.georeference), "WGS 84 / UTM zone 33N");
    const auto [lon, lat] = ToLonLat(*report.tiff.georeference)(cells / 2.0 - 0.5, cells / 2.0 - 0.5);
    EXPECT_NEAR(lon, window.longitude, 1e-8);
    EXPECT_NEAR(lat, window.latitude, 1e-8);
}

TEST(CityImport, draws_geojson) {
    const Source source("scene.geojson", geojson(scene()));
    const ImportReport report = import_city(source.path(), window);
    expect_scene(report);
    EXPECT_EQ(report.tiff.title, "scene, 120 m around 13.4000, 52.5200");
    EXPECT_EQ(label_tiff_bytes(report.tiff), label_tiff_bytes(import_city(source.path(), window).tiff));
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
    EXPECT_EQ(crs_name(*report.tiff.georeference), "WGS 84 / UTM zone 60N");
}

TEST(CityImport, takes_a_box_across_the_date_line) {
    const Source source("fiji.geojson", R"({"type":"MultiPolygon","coordinates":[)"
                                        R"([[[179.9995,-17.0005],[180,-17.0005],[180,-17],[179.9995,-17],[179.9995,-17.0005]]],)"
                                        R"([[[-180,-17.0005],[-179.9995,-17.0005],[-179.9995,-17],[-180,-17],[-180,-17.0005]]]]})");
    const ImportReport report = import_city(
        source.path(),
        {.cell = 5, .box = std::array{179.999, -17.001, -179.999, -16.9995}, .profile = Profile::paper});
    EXPECT_NEAR(report.tiff.map.width() * 5, 213, 10);
    EXPECT_NEAR(report.area, 0.001 * 106470 * 0.0005 * 110650, 20);
    const auto box = lon_lat_box(*report.tiff.georeference, report.tiff.map.width(), report.tiff.map.height());
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
    expect({181, 52, 120, 10}, "--center 181,52");
    expect({13, 85, 120, 10}, "--center 13,85");
    expect({nan, 52, 120, 10}, "--center");
    expect({13, 52, 120, 0}, "--cell 0");
    expect({13, 52, 120, -1}, "--cell -1");
    expect({13, 52, 120, nan}, "--cell nan");
    expect({13, 52, 0, 10}, "--size 0");
    expect({13, 52, nan, 10}, "--size nan");
    expect({13, 52, 1e300, 10}, "--size");
    expect({13, 52, 16385, 1}, "--size 16385");
    expect({13, 52, 200000, 100}, "--size 200000");
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
    expect("overpass.json", R"({"generator":"Overpass API","elements":[]})", "ask for XML: begin the query with [out:xml]");
    expect("buildings.zip", "PK\x03\x04 etc", "is a ZIP archive: unpack it");
    expect("buildings.parquet", "PAR1 etc", "is Parquet");
    expect("city.o5m", "\xff\xe0\x04o5m2", "osmium cat");
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
}  // namespace waybreaker::geo
