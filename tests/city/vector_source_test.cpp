// Sources as people have them: folders, comments before the root, nodes in any order, windows beyond the data.
#include "city/vector_source.hpp"

#include <fmt/format.h>
#include <gdal_utils.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "city/city_import.hpp"
#include "geotiff/xml_root.hpp"
#include "input_error.hpp"
#include "temporary_folder.hpp"

namespace waybreaker::city {
namespace {

const ImportOptions window{.longitude = 9, .latitude = 50, .size = 120, .cell = 10, .section = 0};
constexpr double degree_east = 71667;  // metres on UTM's grid, around 9,50
constexpr double degree_north = 111184;

struct Node {
    std::int64_t id;
    double lon, lat;
};

// A square of 40 m in the middle of the window, its corners numbered from `first` by `step`.
std::vector<Node> square(std::int64_t first = 1, std::int64_t step = 1) {
    const double e = 20 / degree_east;
    const double n = 20 / degree_north;
    return {{first, 9 - e, 50 - n},
            {first + step, 9 + e, 50 - n},
            {first + 2 * step, 9 + e, 50 + n},
            {first + 3 * step, 9 - e, 50 + n}};
}

std::string osm_xml(const std::vector<Node>& nodes, const std::vector<std::int64_t>& way,
                    const std::string& prologue = "", const std::string& bounds = "",
                    const std::string& tag = "building") {
    std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" + prologue + "<osm version=\"0.6\">" + bounds;
    for (const Node& node : nodes) {
        text += fmt::format("<node id=\"{}\" lat=\"{:.7f}\" lon=\"{:.7f}\"/>", node.id, node.lat, node.lon);
    }
    text += "<way id=\"7\">";
    for (const std::int64_t ref : way) text += fmt::format("<nd ref=\"{}\"/>", ref);
    return text + fmt::format("<tag k=\"{}\" v=\"yes\"/></way></osm>\n", tag);
}

// Protocol buffers by hand, as far as a .osm.pbf needs them.
std::string varint(std::uint64_t value) {
    std::string bytes;
    for (; value > 127; value >>= 7) bytes += char(value | 128);
    return bytes + char(value);
}

std::uint64_t zigzag(std::int64_t value) {
    return (std::uint64_t(value) << 1) ^ std::uint64_t(value >> 63);
}

std::string field(unsigned number, const std::string& bytes) {
    return varint(number << 3 | 2) + varint(bytes.size()) + bytes;
}

std::string field(unsigned number, std::uint64_t value) {
    return varint(number << 3) + varint(value);
}

std::string deltas(const std::vector<std::int64_t>& values) {
    std::string bytes;
    std::int64_t last = 0;
    for (const std::int64_t value : values) bytes += varint(zigzag(value - std::exchange(last, value)));
    return bytes;
}

// `index` is what some programs write so that readers can skip blobs.
std::string blob(const std::string& type, const std::string& data, const std::string& index) {
    const std::string body = field(1, data);
    const std::string header = field(1, type) + (index.empty() ? "" : field(2, index)) + field(3, body.size());
    return std::string("\0\0", 2) + char(header.size() >> 8) + char(header.size()) + header + body;
}

std::string osm_pbf(const std::vector<Node>& nodes, const std::vector<std::int64_t>& way,
                    const std::string& index = "") {
    std::vector<std::int64_t> ids;
    std::vector<std::int64_t> lats;
    std::vector<std::int64_t> lons;
    for (const Node& node : nodes) {
        ids.push_back(node.id);
        lats.push_back(std::int64_t(node.lat * 1e7));
        lons.push_back(std::int64_t(node.lon * 1e7));
    }
    const std::string dense = field(1, deltas(ids)) + field(8, deltas(lats)) + field(9, deltas(lons));
    const std::string building = field(1, 7) + field(2, varint(1)) + field(3, varint(2)) + field(8, deltas(way));
    const std::string words = field(1, "") + field(1, "building") + field(1, "yes");
    return blob("OSMHeader", field(4, "OsmSchema-V0.6") + field(4, "DenseNodes"), index) +
           blob("OSMData", field(1, words) + field(2, field(2, dense)) + field(2, field(3, building)), index);
}

class Sources : public TemporaryFolder {
  protected:
    // The one building of each of these files, which say nothing of the ground around it.
    void expect_building(const std::string& file) const {
        ImportOptions options = window;
        options.unknown_free = true;
        const ImportReport report = import_city(file, options);
        ASSERT_EQ(report.tiff.map.obstacles().size(), 1U);
        EXPECT_EQ(report.tiff.map.obstacles()[0].cells, 16U);
        EXPECT_EQ(report.tiff.map.obstacles()[0].source_id, 7);
    }
};

TEST_F(Sources, OfOpenStreetMapBeginLate) {
    const std::vector<std::int64_t> way{1, 2, 3, 4, 1};
    for (const std::string& prologue :
         {std::string(), "<!-- " + std::string(5000, 'x') + " -->\n", "<!-- <osm> " + std::string(5000, 'x') + " -->",
          "<?xml-stylesheet " + std::string(2000, ' ') + "?><!DOCTYPE osm>" + std::string(2000, '\n')}) {
        SCOPED_TRACE(prologue.substr(0, 20));
        expect_building(put("late.osm", osm_xml(square(), way, prologue)));
    }
    const std::string text = osm_xml(square(), way, "<!-- " + std::string(5000, 'x') + " -->\n");
    VSILFILE* packed = VSIFOpenL(("/vsigzip/" + path("late.osm.gz")).c_str(), "wb");
    VSIFWriteL(text.data(), 1, text.size(), packed);
    VSIFCloseL(packed);
    expect_building(path("late.osm.gz"));
}

// They are a way to fill the memory of who reads them.
TEST_F(Sources, WithEntitiesAreRefused) {
    const std::string text = osm_xml(square(), {1, 2, 3, 4, 1}, "<!DOCTYPE osm [ <!ENTITY a \"b\"> ]>");
    EXPECT_NE(input_error([&] { import_city(put("entities.osm", text), window); }).find("entities are not supported"),
              std::string::npos);
}

TEST(XmlRoots, StandPastWhateverComesFirst) {
    const auto expect = [](std::string_view text, std::size_t at, std::string_view name) {
        const auto root = geotiff::xml_root(text);
        ASSERT_TRUE(root) << text;
        EXPECT_EQ(root->at, at) << text;
        EXPECT_EQ(root->name, name) << text;
    };
    expect("<osm>", 0, "osm");
    expect("\xEF\xBB\xBF \n<osm version='0.6'>", 5, "osm");
    expect("<?xml?><!-- <osm> > --><osm/>", 23, "osm");
    expect("<!DOCTYPE osm SYSTEM 'a'><osm\n", 25, "osm");
    expect("<!DOCTYPE osm [<!ENTITY a '>'>]><osm ", 32, "osm");
    expect("<wfs:FeatureCollection>", 0, "wfs:FeatureCollection");
    for (const char* none :
         {"", "osm", "<osm", "<>", "< osm>", "<!-- <osm>", "<?xml <osm>", "<!DOCTYPE [ <osm>", "<!D"}) {
        EXPECT_FALSE(geotiff::xml_root(none)) << none;
    }
}

// Editors give new nodes negative ids, and nobody must sort them.
TEST_F(Sources, OfOpenStreetMapInAnyOrder) {
    for (const std::int64_t first : {1, -8}) {
        for (const bool reversed : {false, true}) {
            SCOPED_TRACE(fmt::format("from {}, reversed {}", first, reversed));
            std::vector<Node> nodes = square(first);
            const std::vector<std::int64_t> way{first, first + 1, first + 2, first + 3, first};
            if (reversed) std::reverse(nodes.begin(), nodes.end());
            expect_building(put("any.osm", osm_xml(nodes, way)));
            expect_building(put("any.osm.pbf", osm_pbf(nodes, way)));
        }
    }
    expect_building(
        put("huge.osm", osm_xml(square(std::int64_t{1} << 40),
                                {1 + (std::int64_t{1} << 40), 2 + (std::int64_t{1} << 40), 3 + (std::int64_t{1} << 40),
                                 std::int64_t{1} << 40, 1 + (std::int64_t{1} << 40)})));
}

TEST_F(Sources, OfOpenStreetMapWithAnIndex) {
    for (const std::size_t size : {0U, 20U, 3000U}) {
        expect_building(put("index.osm.pbf", osm_pbf(square(), {1, 2, 3, 4, 1}, std::string(size, 'i'))));
    }
}

TEST_F(Sources, PackedInAWayThatIsNotReadSaySo) {
    EXPECT_EQ(input_error([&] { open_source(put("a.osm.bz2", "BZh91AY&SY")); }),
              path("a.osm.bz2") + ": is packed with bzip2: unpack it with 'bunzip2 -k'");
    EXPECT_NE(input_error([&] {
                  open_source(put("a.osm.xz",
                                  "\xfd"
                                  "7zXZ"));
              }).find("unxz"),
              std::string::npos);
    EXPECT_NE(input_error([&] { open_source(put("a.osm.zst", "\x28\xb5\x2f\xfd")); }).find("unzstd"),
              std::string::npos);
    EXPECT_EQ(input_error([&] { open_source(path("none")); }), path("none") + ": no such file");
    std::filesystem::create_directory(path("folder"));
    put("folder/readme.txt", "hello");
    EXPECT_NE(input_error([&] { open_source(path("folder")); }).find("is a folder"), std::string::npos);
}

// What a file states, else what was found.
TEST_F(Sources, SayHowMuchOfTheWindowTheyCover) {
    const std::vector<std::int64_t> way{1, 2, 3, 4, 1};
    const auto covered = [&](double west, double south, double east, double north) {
        const std::string bounds = fmt::format(
            "<bounds minlat=\"{:.7f}\" minlon=\"{:.7f}\" maxlat=\"{:.7f}\" maxlon=\"{:.7f}\"/>",
            50 + south / degree_north, 9 + west / degree_east, 50 + north / degree_north, 9 + east / degree_east);
        return import_city(put("bounds.osm", osm_xml(square(), way, "", bounds)), window).covered;
    };
    EXPECT_NEAR(covered(-500, -500, 500, 500), 1, 1e-6);
    EXPECT_NEAR(covered(-60, -60, 60, 60), 1, 1e-3);
    EXPECT_NEAR(covered(-60, -60, 0, 60), 0.5, 1e-3);
    EXPECT_NEAR(covered(-60, -500, 0, 0), 0.25, 1e-3);
    EXPECT_NEAR(import_city(put("none.osm", osm_xml(square(), way)), window).covered, 1.0 / 9, 1e-3);
    const std::string ring = fmt::format("[[[{0},{1}],[{2},{1}],[{2},{3}],[{0},{1}]]]", 9 - 60 / degree_east,
                                         50 - 60 / degree_north, 9.0, 50 + 60 / degree_north);
    const std::string json =
        R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{"building":"yes"},"geometry":{"type":"Polygon","coordinates":)" +
        ring + "}}]}";
    EXPECT_NEAR(import_city(put("half.geojson", json), window).covered, 0.5, 1e-3);
}

// A filter that is misspelt must not look like a map without such obstacles.
TEST_F(Sources, AreNotSilentAboutFiltersThatMatchNothing) {
    const double far = 1;  // a degree east
    std::vector<Node> nodes = square();
    for (Node node : square(11)) {
        node.lon += far;
        nodes.push_back(node);
    }
    std::string text = osm_xml(nodes, {1, 2, 3, 4, 1});
    text.insert(text.find("</osm>"),
                R"(<way id="8"><nd ref="11"/><nd ref="12"/><nd ref="13"/><nd ref="14"/><nd ref="11"/>)"
                R"(<tag k="natural" v="water"/><tag k="depth" v="3 m"/></way>)");
    const std::string file = put("town.osm", text);
    const auto with = [&](const std::function<void(ObstacleChoice&)>& choose) {
        ImportOptions options = window;
        choose(options.choice);
        return input_error([&] { import_city(file, options); });
    };
    // What is elsewhere in the source is spelt well.
    EXPECT_EQ(with([](ObstacleChoice& c) { c.obstacles = parse_tag_filters("building,natural=water"); }), "");
    EXPECT_EQ(with([](ObstacleChoice& c) {
                  c.obstacles = parse_tag_filters("*");
                  c.protect = parse_tag_filters("natural=water");
                  c.weight = {.of = "depth"};
              }),
              "");
    EXPECT_EQ(with([](ObstacleChoice& c) { c.obstacles = parse_tag_filters("building,natural=watr"); }),
              "obstacles 'natural=watr': no area or line of " + file + " is that; is it spelt as the source has it?");
    EXPECT_NE(
        with([](ObstacleChoice& c) { c.destructible = parse_tag_filters("amenity"); }).find("destructible 'amenity'"),
        std::string::npos);
    // There is water, but none among the obstacles.
    EXPECT_NE(with([](ObstacleChoice& c) {
                  c.protect = parse_tag_filters("natural=water");
              }).find("protected 'natural=water': no obstacle of "),
              std::string::npos);
    EXPECT_NE(
        with([](ObstacleChoice& c) { c.weight = {.of = "levels"}; }).find("obstacle-weight 'levels': no obstacle of"),
        std::string::npos);
    EXPECT_NE(with([](ObstacleChoice& c) { c.breach_time = {.of = "building"}; }).find("says a number above 0 there"),
              std::string::npos);
}

// Shapefiles made of the town, in a folder of their own.
TEST_F(Sources, OfSeveralLayersAskWhich) {
    GDALAllRegister();
    const std::string town = put("town.osm", osm_xml(square(), {1, 2, 3, 4, 1}));
    std::filesystem::create_directory(path("shapes"));
    const auto add_shapefile = [&](const std::string& name, const char* columns) {
        const GDALDatasetUniquePtr file(GDALDataset::Open(town.c_str(), GDAL_OF_VECTOR));
        CPLStringList arguments;
        for (const char* argument : {"-f", "ESRI Shapefile", "-sql", columns}) arguments.AddString(argument);
        GDALVectorTranslateOptions* options = GDALVectorTranslateOptionsNew(arguments.List(), nullptr);
        GDALDatasetH in = GDALDataset::ToHandle(file.get());
        GDALClose(GDALVectorTranslate(path("shapes/" + name).c_str(), nullptr, 1, &in, options, nullptr));
        GDALVectorTranslateOptionsFree(options);
    };
    add_shapefile("houses.shp", "SELECT osm_way_id FROM multipolygons");
    EXPECT_EQ(import_city(path("shapes"), window).buildings, 1U);
    add_shapefile("parks.shp", "SELECT osm_way_id FROM multipolygons");
    const std::string asked = input_error([&] { import_city(path("shapes"), window); });
    EXPECT_NE(asked.find("layer is missing: " + path("shapes") + " has 2 layers of areas ("), std::string::npos)
        << asked;
    EXPECT_NE(asked.find("houses"), std::string::npos);
    ImportOptions options = window;
    options.choice.layer = "houses";
    EXPECT_EQ(import_city(path("shapes"), options).buildings, 1U);
    options.choice.layer = "hous";
    EXPECT_NE(input_error([&] { import_city(path("shapes"), options); }).find("has no layer 'hous'; it has "),
              std::string::npos);
    // One of them says what a building is.
    add_shapefile("all.shp", "SELECT building FROM multipolygons");
    EXPECT_EQ(import_city(path("shapes"), window).buildings, 1U);
}

}  // namespace
}  // namespace waybreaker::city
