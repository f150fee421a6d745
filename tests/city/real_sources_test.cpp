// Real extracts against GDAL's own count and area of the same buildings, and against landmarks everybody knows.
#include <cpl_error.h>
#include <gdal_priv.h>
#include <gdal_utils.h>
#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <ostream>

#include "city/city_import.hpp"
#include "city/overlay_source.hpp"
#include "project_folder.hpp"

namespace waybreaker::city {
namespace {

std::string shared_file(const std::string& name) {
    const char* folder = std::getenv("WAYBREAKER_SHARED");
    return (folder ? std::string(folder) : (project_folder() / "../shared").string()) + "/data/osm/" + name;
}

std::string committed_file(const std::string& name) {
    return (project_folder() / "data" / name).string();
}

geotiff::LabelTiff read_map(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return geotiff::read_label_tiff(std::string{std::istreambuf_iterator<char>(file), {}}, path);
}

double blocked_area(const geotiff::LabelTiff& tiff) {
    double cells = 0;
    for (const Obstacle& obstacle : tiff.map.obstacles()) cells += obstacle.cells;
    return cells * tiff.cell_size * tiff.cell_size;
}

double density(const Map& map) {
    double cells = 0;
    for (const Obstacle& obstacle : map.obstacles()) cells += obstacle.cells;
    return cells / double(map.grid().cell_count());
}

// What `ogr2ogr -t_srs ... -clipsrc ...` finds in the window: how many buildings, and the ground they cover together.
struct GdalFigures {
    std::size_t buildings = 0;
    double covered = 0;
};

GDALDatasetUniquePtr translated(GDALDataset& in, const std::vector<std::string>& arguments) {
    CPLStringList list;
    for (const std::string& argument : arguments) list.AddString(argument.c_str());
    GDALVectorTranslateOptions* options = GDALVectorTranslateOptionsNew(list.List(), nullptr);
    GDALDatasetH handle = GDALDataset::ToHandle(&in);
    GDALDatasetUniquePtr out(GDALDataset::FromHandle(GDALVectorTranslate("", nullptr, 1, &handle, options, nullptr)));
    GDALVectorTranslateOptionsFree(options);
    return out;
}

GdalFigures ask_gdal(const std::string& gdal_path, bool osm, const geotiff::LabelTiff& tiff) {
    const CPLErrorHandlerPusher quiet(CPLQuietErrorHandler);  // real data has its self-crossing polygons
    GDALAllRegister();
    const auto& transform = tiff.georeference->transform;
    const double side = tiff.map.width() * tiff.cell_size;
    const GDALDatasetUniquePtr in(GDALDataset::Open(gdal_path.c_str(), GDAL_OF_VECTOR));
    std::vector<std::string> project{"-f",       "Memory", "-t_srs",   tiff.georeference->crs, "-makevalid", "-nlt",
                                     "GEOMETRY", "-nln",   "buildings"};
    if (osm) project.insert(project.end(), {"-where", "building is not null and building <> 'no'", "multipolygons"});
    const GDALDatasetUniquePtr projected = translated(*in, project);
    const GDALDatasetUniquePtr clipped =
        translated(*projected, {"-f", "Memory", "-nlt", "GEOMETRY", "-clipsrc", std::to_string(transform[0]),
                                std::to_string(transform[3] - side), std::to_string(transform[0] + side),
                                std::to_string(transform[3])});

    GdalFigures figures;
    OGRMultiPolygon pieces;
    for (const OGRFeatureUniquePtr& feature : *clipped->GetLayer(0)) {
        OGRGeometry* shape = feature->GetGeometryRef();
        if (shape == nullptr || !(OGR_G_Area(OGRGeometry::ToHandle(shape)) > 0)) continue;
        ++figures.buildings;
        const std::unique_ptr<OGRGeometry> polygons(OGRGeometryFactory::forceToMultiPolygon(shape->clone()));
        for (const OGRPolygon* polygon : *polygons->toMultiPolygon()) pieces.addGeometry(polygon);
    }
    const std::unique_ptr<OGRGeometry> together(pieces.UnionCascaded());
    figures.covered = OGR_G_Area(OGRGeometry::ToHandle(together.get()));
    return figures;
}

struct Extract {
    const char* file;
    double longitude;
    double latitude;
};

std::ostream& operator<<(std::ostream& out, const Extract& extract) {
    return out << extract.file;
}

class RealSources : public testing::TestWithParam<Extract> {};

TEST_P(RealSources, agree_with_gdal) {
    const Extract& extract = GetParam();
    const std::string path = shared_file(extract.file);
    if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is absent";
    const ImportReport report =
        import_city(path, {.longitude = extract.longitude, .latitude = extract.latitude, .profile = Profile::paper});
    const bool gzip = path.ends_with(".gz");
    const GdalFigures gdal = ask_gdal((gzip ? "/vsigzip/" : "") + path, !path.ends_with(".shp"), report.tiff);
    EXPECT_EQ(report.buildings, gdal.buildings);
    EXPECT_NEAR(blocked_area(report.tiff), gdal.covered, 0.01 * gdal.covered);
    EXPECT_GE(report.area, gdal.covered);
}

INSTANTIATE_TEST_SUITE_P(
    Extracts, RealSources,
    testing::Values(Extract{"manhattan.osm.pbf", -73.9855, 40.748}, Extract{"monaco.osm.pbf", 7.425, 43.738},
                    Extract{"kyoto.osm.gz", 135.765, 34.96}, Extract{"berlin-mitte.osm.gz", 13.395, 52.5213},
                    Extract{"moscow-west_buildings.shp", 37.3, 55.68}, Extract{"turin_buildings.shp", 7.674, 45.069}));

// Whole sources against what osmium makes of them: `osmium tags-filter SOURCE wr/building`, then `osmium export
// --geometry-types=polygon`, and the areas of that in UTM; holes, multipolygons and all. In Krems
// osmium passes over the holes of 13 relations that leave their tags to the outer way.
struct OsmiumFigures {
    const char* file;
    std::array<double, 4> box;
    std::size_t buildings;
    double area;
};

std::ostream& operator<<(std::ostream& out, const OsmiumFigures& figures) {
    return out << figures.file;
}

class WholeSources : public testing::TestWithParam<OsmiumFigures> {};

TEST_P(WholeSources, agree_with_osmium) {
    const OsmiumFigures& osmium = GetParam();
    const std::string path = shared_file(osmium.file);
    if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is absent";
    ImportOptions options{.cell = 100, .profile = Profile::paper};
    options.box = osmium.box;
    const ImportReport report = import_city(path, options);
    EXPECT_EQ(report.buildings, osmium.buildings);
    EXPECT_NEAR(report.area, osmium.area, 0.01 * osmium.area);
}

INSTANTIATE_TEST_SUITE_P(Sources, WholeSources,
                         testing::Values(OsmiumFigures{"monaco.osm.pbf", {7.3, 43.4, 7.6, 43.9}, 1283, 731871.47},
                                         OsmiumFigures{
                                             "berlin-mitte.osm.gz", {13.2, 52.3, 13.7, 52.7}, 1993, 1188818.88},
                                         OsmiumFigures{"krems.osm.gz", {15.3, 48.2, 15.9, 48.6}, 1195, 832971.05}));

// The maps of data/, as data/README.md says they were made.
struct CommittedMap {
    const char* file;
    const char* source;
    ImportOptions options;
    std::size_t obstacles;
    double density;
    Cell start;  // of the mission data/README.md proposes
    Cell goal;
};

std::ostream& operator<<(std::ostream& out, const CommittedMap& map) {
    return out << map.file;
}

class CommittedMaps : public testing::TestWithParam<CommittedMap> {};

TEST_P(CommittedMaps, hold_what_they_should) {
    const CommittedMap& expected = GetParam();
    const geotiff::LabelTiff tiff = read_map(committed_file(expected.file));
    EXPECT_EQ(tiff.map.width(), 501);
    EXPECT_EQ(tiff.map.height(), 501);
    EXPECT_EQ(tiff.cell_size, 2.4);
    EXPECT_EQ(tiff.map.obstacles().size(), expected.obstacles);
    EXPECT_NEAR(density(tiff.map), expected.density, 5e-4);
    EXPECT_EQ(tiff.annotations.attribution, "(c) OpenStreetMap contributors, ODbL 1.0");
    for (const Obstacle& obstacle : tiff.map.obstacles()) {
        if (obstacle.source_id != 0) continue;
        ASSERT_FALSE(tiff.annotations.kinds.empty());
        const site::ObstacleKind kind = tiff.annotations.kinds[obstacle.id.value];
        EXPECT_TRUE(kind == site::ObstacleKind::water || kind == site::ObstacleKind::unknown);  // the sea, no data
    }
    const auto [lon, lat] = geotiff::ToLonLat(*tiff.georeference)(250, 250);
    EXPECT_NEAR(lon, expected.options.longitude, 1e-7);
    EXPECT_NEAR(lat, expected.options.latitude, 1e-7);
    EXPECT_GT(distance(expected.start, expected.goal), 250);
    EXPECT_FALSE(tiff.map.obstacle_at(expected.start));
    EXPECT_FALSE(tiff.map.obstacle_at(expected.goal));
}

TEST_P(CommittedMaps, can_be_made_again) {
    const CommittedMap& expected = GetParam();
    const std::string source = shared_file(expected.source);
    if (!std::filesystem::exists(source)) GTEST_SKIP() << source << " is absent";
    const geotiff::LabelTiff committed = read_map(committed_file(expected.file));
    const geotiff::LabelTiff made = import_city(source, expected.options).tiff;
    EXPECT_TRUE(std::equal(made.map.labels().begin(), made.map.labels().end(), committed.map.labels().begin(),
                           committed.map.labels().end()));
    EXPECT_TRUE(std::equal(made.map.obstacles().begin(), made.map.obstacles().end(), committed.map.obstacles().begin(),
                           committed.map.obstacles().end(),
                           [](const Obstacle& a, const Obstacle& b) { return a.source_id == b.source_id; }));
    EXPECT_EQ(made.annotations.names, committed.annotations.names);
    EXPECT_EQ(geotiff::label_tiff_bytes(made), geotiff::label_tiff_bytes(committed));
    EXPECT_EQ(made.annotations.title, committed.annotations.title);
    EXPECT_EQ(made.georeference->crs, committed.georeference->crs);
}

INSTANTIATE_TEST_SUITE_P(Data, CommittedMaps,
                         testing::Values(CommittedMap{"andorra.tif",
                                                      "andorra.osm.pbf",
                                                      {1.528, 42.5085, 1202.4, 2.4, false, {}, Profile::rover},
                                                      1934,
                                                      0.2790,
                                                      {251, 185},
                                                      {395, 395}},
                                         CommittedMap{"krems.tif",
                                                      "krems.osm.gz",
                                                      {15.608, 48.4086, 1202.4, 2.4, false, {}, Profile::rover},
                                                      1683,
                                                      0.3744,
                                                      {100, 37},
                                                      {40, 398}},
                                         CommittedMap{"berlin-adlershof.tif",
                                                      "berlin-adlershof.osm.gz",
                                                      {13.5378, 52.4325, 1202.4, 2.4, false, {}, Profile::rover},
                                                      2122,
                                                      0.3014,
                                                      {130, 104},
                                                      {466, 105}},
                                         CommittedMap{"berlin-mitte.tif",
                                                      "berlin-mitte.osm.gz",
                                                      {13.383, 52.5213, 1202.4, 2.4, false, {}, Profile::rover},
                                                      2053,
                                                      0.3039,
                                                      {485, 101},
                                                      {425, 488}},
                                         CommittedMap{"manhattan.tif",
                                                      "manhattan.osm.pbf",
                                                      {-73.9855, 40.748, 1202.4, 2.4, false, {}, Profile::rover},
                                                      3436,
                                                      0.5456,
                                                      {354, 45},
                                                      {16, 237}},
                                         CommittedMap{"honolulu.tif",
                                                      "honolulu.osm.pbf",
                                                      {-157.86, 21.305, 1202.4, 2.4, false, {}, Profile::rover},
                                                      1912,
                                                      0.3748,
                                                      {435, 408},
                                                      {340, 93}},
                                         CommittedMap{"kyoto.tif",
                                                      "kyoto.osm.gz",
                                                      {135.76, 34.9615, 1202.4, 2.4, false, {}, Profile::rover},
                                                      2069,
                                                      0.2936,
                                                      {177, 253},
                                                      {475, 244}},
                                         CommittedMap{"monaco.tif",
                                                      "monaco.osm.pbf",
                                                      {7.4215, 43.7345, 1202.4, 2.4, false, {}, Profile::rover},
                                                      2029,
                                                      0.4683,
                                                      {301, 63},
                                                      {375, 345}},
                                         CommittedMap{"turin.tif",
                                                      "turin_buildings.shp",
                                                      {7.674, 45.069, 1202.4, 2.4, true, {}, Profile::paper},
                                                      259,
                                                      0.3571,
                                                      {48, 136},
                                                      {433, 257}}));

TEST(CommittedMapUnderAFlood, is_that_of_krems_with_its_flood) {
    geotiff::LabelTiff krems = read_map(committed_file("krems.tif"));
    site::DescribedMap map{krems.map, krems.annotations};
    lay_over({.file = committed_file("krems-flood.geojson")}, *krems.georeference, {}, map);
    krems.map = map.map;
    krems.annotations = map.annotations;
    EXPECT_EQ(geotiff::label_tiff_bytes(krems),
              geotiff::label_tiff_bytes(read_map(committed_file("krems-flooded.tif"))));
}

// The Empire State Building: its published coordinates fall on the obstacle with its OpenStreetMap id, and come back.
TEST(CommittedMapOfManhattan, has_the_empire_state_building_where_it_stands) {
    constexpr double longitude = -73.98566;
    constexpr double latitude = 40.74844;
    constexpr std::int64_t way = 34633854;
    const geotiff::LabelTiff tiff = read_map(committed_file("manhattan.tif"));
    OGRSpatialReference utm(tiff.georeference->crs.c_str());
    OGRSpatialReference wgs84;
    wgs84.SetWellKnownGeogCS("WGS84");
    wgs84.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    const std::unique_ptr<OGRCoordinateTransformation> to_utm(OGRCreateCoordinateTransformation(&wgs84, &utm));
    double east = longitude;
    double north = latitude;
    ASSERT_TRUE(to_utm->Transform(1, &east, &north));
    const auto& transform = tiff.georeference->transform;
    const Cell cell{int((east - transform[0]) / 2.4), int((transform[3] - north) / 2.4)};
    const ObstacleId id = tiff.map.obstacle_at(cell);
    ASSERT_TRUE(id);
    EXPECT_EQ(tiff.map.obstacle(id).source_id, way);
    EXPECT_EQ(tiff.annotations.names.at(id.value), "Empire State Building");

    const auto [lon, lat] = geotiff::ToLonLat(*tiff.georeference)(cell.x, cell.y);
    const double metres_east = (lon - longitude) * 111320 * std::cos(latitude * 3.14159265 / 180);
    const double metres_north = (lat - latitude) * 111050;
    // UTM's grid is turned by up to a degree or so against true north.
    EXPECT_LE(std::abs(metres_east), 1.2 * 1.05);
    EXPECT_LE(std::abs(metres_north), 1.2 * 1.05);
}

}  // namespace
}  // namespace waybreaker::city
