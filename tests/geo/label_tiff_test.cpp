// Label maps survive their file format, and GDAL's own tools; whatever else comes is refused in one helpful line.
#include "geo/label_tiff.hpp"

#include <gdal_priv.h>
#include <gdal_utils.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <functional>

#include "waybreaker/error.hpp"

namespace waybreaker::geo {
namespace {

const char* const memory_path = "/vsimem/label_tiff_test.tif";

std::string take_memory_file() {
    vsi_l_offset size = 0;
    const GByte* data = VSIGetMemFileBuffer(memory_path, &size, FALSE);
    std::string bytes(reinterpret_cast<const char*>(data), size);
    VSIUnlink(memory_path);
    return bytes;
}

// What another program might have written: an 8 x 4 raster of `type`, changed by `edit` before it is closed.
std::string foreign_tiff(GDALDataType type, int bands, const std::function<void(GDALDataset&)>& edit = {},
                         int width = 8, int height = 4, const char* option = nullptr) {
    GDALAllRegister();
    CPLStringList options;
    if (option) options.AddString(option);
    GDALDatasetUniquePtr file(GetGDALDriverManager()->GetDriverByName("GTiff")->Create(memory_path, width, height,
                                                                                       bands, type, options.List()));
    if (edit) edit(*file);
    file.reset();
    return take_memory_file();
}

void write_cells(GDALDataset& file, std::vector<std::int32_t> cells) {
    ASSERT_EQ(cells.size(), 32U);
    ASSERT_EQ(file.GetRasterBand(1)->RasterIO(GF_Write, 0, 0, 8, 4, cells.data(), 8, 4, GDT_Int32, 0, 0, nullptr),
              CE_None);
}

// The same file after `gdal_translate OPTIONS`.
std::string translated(const std::string& bytes, const std::vector<const char*>& arguments) {
    GDALAllRegister();
    const char* const in_path = "/vsimem/label_tiff_test_in.tif";
    std::string copy = bytes;
    VSIFCloseL(VSIFileFromMemBuffer(in_path, reinterpret_cast<GByte*>(copy.data()), copy.size(), FALSE));
    CPLStringList list;
    for (const char* argument : arguments) list.AddString(argument);
    GDALTranslateOptions* options = GDALTranslateOptionsNew(list.List(), nullptr);
    GDALDatasetUniquePtr in(GDALDataset::Open(in_path));
    GDALClose(GDALTranslate(memory_path, GDALDataset::ToHandle(in.get()), options, nullptr));
    GDALTranslateOptionsFree(options);
    in.reset();
    VSIUnlink(in_path);
    return take_memory_file();
}

using Kind = site::ObstacleKind;

// 5 x 3 cells, three obstacles in two touching pieces and one apart, in UTM zone 33N.
LabelTiff small_map() {
    const std::vector<ObstacleAttributes> attributes{{}, {true, 4711}, {false, -12345678901}, {true, 0}};
    OGRSpatialReference utm;
    utm.SetWellKnownGeogCS("WGS84");
    utm.SetUTM(33, TRUE);
    char* text = nullptr;
    utm.exportToWkt(&text);
    LabelTiff tiff{.map = Map::from_labels(5, 3,
                                           {1, 1, 2, 0, 0,  //
                                            0, 2, 2, 0, 3,  //
                                            0, 0, 0, 0, 3},
                                           attributes),
                   .cell_size = 2.4,
                   .georeference = site::Georeference{text, {390000.25, 2.4, 0, 5820000.75, 0, -2.4}},
                   .attribution = "(c) somebody, some licence 1.0",
                   .title = "Place, 12 m around Zürich",
                   .names = {"", "Grand \"Hôtel\" & <Café>", "", "7"},
                   .kinds = {Kind::unknown, Kind::building, Kind::water, Kind::barrier},
                   .sections = {{{Kind::building, 4711, "7"}, {Kind::barrier, -12, ""}}, {{}, {0}, {}, {1}}}};
    CPLFree(text);
    return tiff;
}

void expect_same_obstacles(const Map& a, const Map& b) {
    ASSERT_EQ(a.width(), b.width());
    ASSERT_EQ(a.height(), b.height());
    EXPECT_TRUE(std::equal(a.labels().begin(), a.labels().end(), b.labels().begin(), b.labels().end()));
    ASSERT_EQ(a.obstacles().size(), b.obstacles().size());
    for (std::size_t i = 0; i < a.obstacles().size(); ++i) {
        EXPECT_EQ(a.obstacles()[i].source_id, b.obstacles()[i].source_id);
        EXPECT_EQ(a.obstacles()[i].destructible, b.obstacles()[i].destructible);
        EXPECT_EQ(a.obstacles()[i].bounds, b.obstacles()[i].bounds);
    }
}

TEST(LabelTiff, comes_back_whole) {
    const LabelTiff written = small_map();
    const LabelTiff read = read_label_tiff(label_tiff_bytes(written), "city.tif");
    expect_same_obstacles(written.map, read.map);
    EXPECT_EQ(read.cell_size, 2.4);
    EXPECT_EQ(read.attribution, written.attribution);
    EXPECT_EQ(read.title, written.title);
    EXPECT_EQ(read.names, written.names);
    EXPECT_EQ(read.kinds, written.kinds);
    ASSERT_TRUE(read.georeference);
    EXPECT_EQ(read.georeference->transform, written.georeference->transform);
    EXPECT_EQ(crs_name(*read.georeference), "WGS 84 / UTM zone 33N");
}

TEST(LabelTiff, same_map_gives_same_bytes) {
    EXPECT_EQ(label_tiff_bytes(small_map()), label_tiff_bytes(small_map()));
}

TEST(LabelTiff, keeps_the_cell_size_where_no_place_is_known) {
    const LabelTiff read =
        read_label_tiff(label_tiff_bytes({.map = Map::from_labels(2, 1, {0, 7}), .cell_size = 0.5}), "city.tif");
    EXPECT_EQ(read.cell_size, 0.5);
    EXPECT_FALSE(read.georeference);
}

TEST(LabelTiff, puts_cell_centres_on_the_ground) {
    site::Georeference place = *small_map().georeference;
    const auto [lon, lat] = ToLonLat(place)(4, 2);
    OGRSpatialReference utm(place.crs.c_str());
    OGRSpatialReference wgs84;
    wgs84.SetWellKnownGeogCS("WGS84");
    wgs84.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    std::unique_ptr<OGRCoordinateTransformation> to_utm(OGRCreateCoordinateTransformation(&wgs84, &utm));
    double east = lon;
    double north = lat;
    ASSERT_TRUE(to_utm->Transform(1, &east, &north));
    EXPECT_NEAR(east, 390000.25 + 4.5 * 2.4, 1e-3);
    EXPECT_NEAR(north, 5820000.75 - 2.5 * 2.4, 1e-3);
}

RC_GTEST_PROP(LabelTiff, comes_back_whole_whatever_it_holds, ()) {
    const int width = *rc::gen::inRange(1, 40);
    const int height = *rc::gen::inRange(1, 40);
    const std::size_t cells = std::size_t(width) * std::size_t(height);
    // Large labels now and then: ids of the file do not depend on them.
    const auto labels = *rc::gen::container<std::vector<std::uint32_t>>(
        cells, rc::gen::element<std::uint32_t>(0, 0, 1, 2, 3, 70000, 4000000000));
    std::vector<ObstacleAttributes> attributes(4);
    for (ObstacleAttributes& obstacle : attributes) {
        obstacle = {*rc::gen::arbitrary<bool>(), *rc::gen::arbitrary<std::int64_t>()};
    }
    const LabelTiff written{.map = Map::from_labels(width, height, labels, attributes)};
    expect_same_obstacles(written.map, read_label_tiff(label_tiff_bytes(written), "city.tif").map);
}

TEST(LabelTiff, holds_more_obstacles_than_16_bits) {
    std::vector<std::uint32_t> labels(300 * 300);
    for (std::size_t i = 0; i < labels.size(); ++i) labels[i] = std::uint32_t(i);
    const LabelTiff written{.map = Map::from_labels(300, 300, labels)};
    const LabelTiff read = read_label_tiff(label_tiff_bytes(written), "city.tif");
    EXPECT_EQ(read.map.obstacles().size(), 300U * 300U - 1);
    expect_same_obstacles(written.map, read.map);
}

TEST(LabelTiff, survives_gdal_translate) {
    const LabelTiff original = small_map();
    const std::string bytes = label_tiff_bytes(original);
    const std::vector<std::vector<const char*>> variants{
        {},
        {"-co", "TILED=YES", "-co", "COMPRESS=LZW"},
        {"-ot", "Byte"},
        {"-ot", "Int32", "-co", "BIGTIFF=YES"},
        {"-ot", "UInt32", "-co", "ENDIANNESS=BIG", "-co", "COMPRESS=DEFLATE", "-co", "PREDICTOR=2"},
        {"-of", "COG"},
    };
    for (const auto& arguments : variants) {
        SCOPED_TRACE(arguments.empty() ? "plain" : arguments.back());
        const LabelTiff read = read_label_tiff(translated(bytes, arguments), "city.tif");
        expect_same_obstacles(original.map, read.map);
        EXPECT_EQ(read.attribution, original.attribution);
        EXPECT_EQ(read.title, original.title);
        EXPECT_EQ(read.names, original.names);
        EXPECT_EQ(read.kinds, original.kinds);
        EXPECT_EQ(read.georeference->transform, original.georeference->transform);
    }
}

TEST(LabelTiff, keeps_ids_with_their_obstacles_when_a_piece_is_cut_out) {
    const std::string piece = translated(label_tiff_bytes(small_map()), {"-srcwin", "2", "0", "3", "3"});
    const LabelTiff tiff = read_label_tiff(piece, "piece.tif");
    const Map& map = tiff.map;
    ASSERT_EQ(map.obstacles().size(), 2U);
    EXPECT_EQ(map.obstacle(map.obstacle_at({0, 0})).source_id, -12345678901);
    EXPECT_FALSE(map.obstacle(map.obstacle_at({0, 0})).destructible);
    EXPECT_EQ(map.obstacle(map.obstacle_at({2, 2})).source_id, 0);
    EXPECT_TRUE(map.obstacle(map.obstacle_at({2, 2})).destructible);
    EXPECT_EQ(tiff.names, (site::ObstacleNames{"", "", "7"}));
    EXPECT_EQ(tiff.kinds, (site::ObstacleKinds{Kind::unknown, Kind::water, Kind::barrier}));
    EXPECT_EQ(tiff.sections, (site::Sections{small_map().sections.structures, {{}, {}, {1}}}));
}

TEST(LabelTiff, has_names_of_some_obstacles_whatever_their_numbers) {
    const auto named = [](const char* names) {
        const std::string bytes = foreign_tiff(GDT_UInt32, 1, [names](GDALDataset& f) {
            std::vector<std::int32_t> labels(32, 0);
            labels[3] = 70000;
            labels[4] = labels[9] = 5;
            write_cells(f, labels);
            f.SetMetadataItem("WAYBREAKER_NAMES", names);
        });
        return read_label_tiff(bytes, "city.tif").names;
    };
    EXPECT_EQ(named("5 Town hall\n6 Nobody\n70000  Café \t \x01"), (site::ObstacleNames{"", "Café", "Town hall"}));
    EXPECT_EQ(named("5 First\n5 Second"), (site::ObstacleNames{"", "", "First"}));
    EXPECT_EQ(named("6 Nobody\n5  "), site::ObstacleNames{});
    EXPECT_EQ(named(""), site::ObstacleNames{});
}

TEST(LabelTiff, says_of_some_obstacles_what_they_are) {
    const auto kinds = [](const char* text) {
        const std::string bytes = foreign_tiff(GDT_UInt32, 1, [text](GDALDataset& f) {
            std::vector<std::int32_t> labels(32, 0);
            labels[3] = 70000;
            labels[4] = labels[9] = 5;
            write_cells(f, labels);
            f.SetMetadataItem("WAYBREAKER_KINDS", text);
        });
        return read_label_tiff(bytes, "city.tif").kinds;
    };
    EXPECT_EQ(kinds("water 6 70000\nbarrier 5"), (site::ObstacleKinds{Kind::unknown, Kind::water, Kind::barrier}));
    EXPECT_EQ(kinds("swamp 70000\ncliff 5\n"), (site::ObstacleKinds{Kind::unknown, Kind::unknown, Kind::cliff}));
    EXPECT_EQ(kinds("swamp 70000"), site::ObstacleKinds{});
    EXPECT_EQ(kinds(""), site::ObstacleKinds{});
}

TEST(CleanName, is_one_line_of_whole_characters) {
    EXPECT_EQ(clean_name(" a\r\nb\x1b[31m\x7f"), "a  b [31m");
    EXPECT_EQ(clean_name("Stra\xdf"
                         "e"),
              "Stra?e");
    EXPECT_EQ(clean_name("Caf\u202e\u00e9\u2066 \u05d0\u2028\u0085"), "Café א")
        << "what turns the direction of writing";
    EXPECT_EQ(clean_name("\u05d0\u200f 5, ‘é’ \u2027\u202f\u2065"), "\u05d0\u200f 5, ‘é’ \u2027\u202f\u2065");
    EXPECT_EQ(clean_name(std::string(249, 'x') + "ß"), std::string(249, 'x'));
    EXPECT_EQ(clean_name(std::string(248, 'x') + "ß"), std::string(248, 'x') + "ß");
}

TEST(LabelTiff, takes_cells_without_data_for_free) {
    const std::string bytes = foreign_tiff(GDT_Int16, 1, [](GDALDataset& file) {
        std::vector<std::int32_t> cells(32, -9999);
        cells[9] = 5;
        write_cells(file, cells);
        file.GetRasterBand(1)->SetNoDataValue(-9999);
    });
    const Map map = read_label_tiff(bytes, "foreign.tif").map;
    ASSERT_EQ(map.obstacles().size(), 1U);
    EXPECT_EQ(map.obstacle_at({1, 1}), ObstacleId{1});
    EXPECT_EQ(map.obstacles()[0].cells, 1U);
}

void set_transform(GDALDataset& file, std::array<double, 6> transform) {
    file.SetGeoTransform(transform.data());
}

void fill_mask(GDALRasterBand& mask, const std::vector<std::uint8_t>& counts) {
    ASSERT_EQ(counts.size(), 32U);
    std::vector<std::uint8_t> values = counts;
    ASSERT_EQ(mask.RasterIO(GF_Write, 0, 0, 8, 4, values.data(), 8, 4, GDT_Byte, 0, 0, nullptr), CE_None);
}

// Two obstacles, of which a mask leaves out the second and half of the first.
TEST(LabelTiff, takes_cells_that_are_masked_out_for_free) {
    std::vector<std::int32_t> cells(32, 0);
    std::vector<std::uint8_t> counts(32, 255);
    cells[8] = cells[9] = 5;
    cells[15] = 6;
    counts[9] = counts[15] = 0;
    const auto expect_one = [](const std::string& bytes) {
        const Map map = read_label_tiff(bytes, "foreign.tif").map;
        ASSERT_EQ(map.obstacles().size(), 1U);
        EXPECT_EQ(map.obstacles()[0].cells, 1U);
        EXPECT_EQ(map.obstacle_at({0, 1}), ObstacleId{1});
    };
    CPLSetThreadLocalConfigOption("GDAL_TIFF_INTERNAL_MASK", "YES");
    const std::string masked = foreign_tiff(GDT_Byte, 1, [&](GDALDataset& file) {
        write_cells(file, cells);
        ASSERT_EQ(file.CreateMaskBand(GMF_PER_DATASET), CE_None);
        fill_mask(*file.GetRasterBand(1)->GetMaskBand(), counts);
    });
    CPLSetThreadLocalConfigOption("GDAL_TIFF_INTERNAL_MASK", nullptr);
    expect_one(masked);
    expect_one(foreign_tiff(
        GDT_UInt16, 2,
        [&](GDALDataset& file) {
            write_cells(file, cells);
            file.GetRasterBand(2)->SetColorInterpretation(GCI_AlphaBand);
            fill_mask(*file.GetRasterBand(2), counts);
        },
        8, 4, "ALPHA=YES"));
}

TEST(LabelTiff, measures_cells_in_metres_whatever_the_unit) {
    const std::string bytes = foreign_tiff(GDT_Byte, 1, [](GDALDataset& file) {
        OGRSpatialReference feet;
        feet.importFromEPSG(2263);  // New York Long Island, US survey feet
        file.SetSpatialRef(&feet);
        std::array<double, 6> transform{980000, 10, 0, 210000, 0, -10};
        file.SetGeoTransform(transform.data());
    });
    EXPECT_NEAR(read_label_tiff(bytes, "feet.tif").cell_size, 3.048006, 1e-6);
}

// An empty map of 8 x 4 cells in a coordinate system.
std::string placed_tiff(int epsg, std::array<double, 6> transform) {
    return foreign_tiff(GDT_Byte, 1, [&](GDALDataset& file) {
        OGRSpatialReference system;
        ASSERT_EQ(system.importFromEPSG(epsg), OGRERR_NONE);
        file.SetSpatialRef(&system);
        set_transform(file, transform);
    });
}

std::string refusal_of(const std::string& bytes) {
    try {
        read_label_tiff(bytes, "bad.tif");
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

TEST(LabelTiff, refuses_coordinate_systems_that_stretch_lengths) {
    // At 50 degrees north Web Mercator makes 1.56 m of a metre.
    const std::string mercator = refusal_of(placed_tiff(3857, {1113000, 2, 0, 6446275, 0, -2}));
    EXPECT_NE(mercator.find("has cells of 2 m in WGS 84 / Pseudo-Mercator, which are 1.29 x 1.28 m on the ground"),
              std::string::npos)
        << mercator;
    EXPECT_NE(mercator.find("'gdalwarp -r near -t_srs EPSG:32632'"), std::string::npos) << mercator;
    // An equal-area cylinder keeps areas, but not squares.
    const std::string oblong = refusal_of(placed_tiff(6933, {0, 2, 0, 6000000, 0, -2}));
    EXPECT_NE(oblong.find("on the ground; project it with"), std::string::npos) << oblong;
    EXPECT_NE(refusal_of(placed_tiff(3857, {0, 2, 0, -6446275, 0, -2})).find("EPSG:32731"), std::string::npos);
    // At the equator it is true, and so are zones, countries' grids, and polar ones near their parallel.
    EXPECT_EQ(refusal_of(placed_tiff(3857, {1113000, 2, 0, 4, 0, -2})), "");
    EXPECT_EQ(refusal_of(placed_tiff(32633, {290000, 2, 0, 5500000, 0, -2})), "");
    EXPECT_EQ(refusal_of(placed_tiff(2154, {700000, 2, 0, 6600000, 0, -2})), "");
    EXPECT_EQ(refusal_of(placed_tiff(3035, {4321000, 2, 0, 3210000, 0, -2})), "");
    EXPECT_EQ(refusal_of(placed_tiff(3031, {0, 2, 0, 2082000, 0, -2})), "");
}

TEST(LabelTiff, names_the_zone_of_cells_in_degrees) {
    EXPECT_NE(refusal_of(placed_tiff(4326, {13, 1e-5, 0, 52, 0, -1e-5})).find("EPSG:32633"), std::string::npos);
    EXPECT_NE(refusal_of(placed_tiff(4326, {190, 1e-5, 0, -20, 0, -1e-5})).find("EPSG:32702"), std::string::npos);
    EXPECT_NE(refusal_of(placed_tiff(4326, {10, 1e-5, 0, 86, 0, -1e-5})).find("EPSG:32661"), std::string::npos);
}

// A site's own axes have no longitudes: the map is in a frame of its own, as those of robots are.
TEST(LabelTiff, takes_a_local_system_for_a_frame) {
    const LabelTiff tiff = read_label_tiff(foreign_tiff(GDT_Byte, 1,
                                                        [](GDALDataset& file) {
                                                            OGRSpatialReference site;
                                                            site.SetLocalCS("Site grid");
                                                            site.SetLinearUnits("foot", 0.3048);
                                                            file.SetSpatialRef(&site);
                                                            set_transform(file, {100, 10, 0, 240, 0, -10});
                                                        }),
                                           "site.tif");
    EXPECT_FALSE(tiff.georeference);
    EXPECT_NEAR(tiff.cell_size, 3.048, 1e-9);
    ASSERT_TRUE(tiff.origin);
    EXPECT_NEAR(tiff.origin->at(0), 30.48, 1e-9);
    EXPECT_NEAR(tiff.origin->at(1), 60.96, 1e-9);
}

TEST(LabelTiff, refuses_what_is_no_label_map_and_says_why) {
    const std::string good = label_tiff_bytes(small_map());
    struct Case {
        const char* what;
        std::string bytes;
        const char* message;
    };
    const std::vector<Case> cases{
        {"empty", "", "is no GeoTIFF map"},
        {"text", "type octile\nheight 4\n", "is no GeoTIFF map"},
        {"magic and junk", std::string("II*\0\x08\0\0\0", 8) + std::string(500, '\xff'), "is no GeoTIFF map"},
        {"header cut short", good.substr(0, 10), "is no GeoTIFF map"},
        {"two bands", foreign_tiff(GDT_Byte, 2), "has 2 bands"},
        {"floats", foreign_tiff(GDT_Float32, 1),
         "'gdal_calc.py -A IN.tif --outfile=OUT.tif --type=Byte --calc=\"A>0\"', or with \"~(A<=0)\" if what is no"},
        {"64 bits", foreign_tiff(GDT_Int64, 1), "-ot UInt32"},
        {"too wide", foreign_tiff(GDT_Byte, 1, {}, 40000, 2, "SPARSE_OK=YES"), "-srcwin"},
        {"too many cells", foreign_tiff(GDT_Byte, 1, {}, 20000, 20000, "SPARSE_OK=YES"), "-srcwin"},
        {"more cells than it has bytes for",
         foreign_tiff(GDT_Byte, 1, {}, 16384, 16384, "SPARSE_OK=YES").substr(0, 12000), "cannot hold"},
        {"rotated",
         foreign_tiff(GDT_Byte, 1,
                      [](GDALDataset& f) {
                          set_transform(f, {0, 2, 1, 0, 1, -2});
                      }),
         "not north-up"},
        {"south-up",
         foreign_tiff(GDT_Byte, 1,
                      [](GDALDataset& f) {
                          set_transform(f, {0, 2, 0, 0, 0, 2});
                      }),
         "not north-up"},
        {"oblong cells",
         foreign_tiff(GDT_Byte, 1,
                      [](GDALDataset& f) {
                          set_transform(f, {0, 2, 0, 0, 0, -2.1});
                      }),
         "must be square"},
        {"degrees",
         foreign_tiff(GDT_Byte, 1,
                      [](GDALDataset& f) {
                          OGRSpatialReference wgs84;
                          wgs84.SetWellKnownGeogCS("WGS84");
                          f.SetSpatialRef(&wgs84);
                          set_transform(f, {13, 1e-5, 0, 52, 0, -1e-5});
                      }),
         "in degrees"},
        {"negative id",
         foreign_tiff(GDT_Int32, 1,
                      [](GDALDataset& f) {
                          std::vector<std::int32_t> labels(32, 0);
                          labels[13] = -3;
                          write_cells(f, labels);
                      }),
         "negative obstacle id -3 at cell 5,1"},
        {"-1 for blocked",
         foreign_tiff(GDT_Int16, 1, [](GDALDataset& f) { write_cells(f, std::vector<std::int32_t>(32, -1)); }),
         R"(--calc="A!=0"')"},
        {"damaged ids",
         foreign_tiff(GDT_Byte, 1, [](GDALDataset& f) { f.SetMetadataItem("WAYBREAKER_OBSTACLES", "12,!34,x5"); }),
         "entry 3 of its metadata item"},
        {"a weight of nothing",
         foreign_tiff(GDT_Byte, 1, [](GDALDataset& f) { f.SetMetadataItem("WAYBREAKER_WEIGHTS", "1.5,0"); }),
         "entry 2 of its metadata item WAYBREAKER_WEIGHTS is no number above 0"},
        {"a breach before its time",
         foreign_tiff(GDT_Byte, 1, [](GDALDataset& f) { f.SetMetadataItem("WAYBREAKER_BREACH_TIMES", "-1"); }),
         "entry 1 of its metadata item WAYBREAKER_BREACH_TIMES is no number of at least 0"},
        {"a weight without end",
         foreign_tiff(GDT_Byte, 1, [](GDALDataset& f) { f.SetMetadataItem("WAYBREAKER_WEIGHTS", "inf"); }),
         "entry 1 of its metadata item WAYBREAKER_WEIGHTS"},
        {"ids end in a comma",
         foreign_tiff(GDT_Byte, 1, [](GDALDataset& f) { f.SetMetadataItem("WAYBREAKER_OBSTACLES", "12,"); }),
         "entry 1 of its metadata item"},
        {"a name of nobody",
         foreign_tiff(GDT_Byte, 1, [](GDALDataset& f) { f.SetMetadataItem("WAYBREAKER_NAMES", "3 Town hall\nCafé"); }),
         "line 2 of its metadata item WAYBREAKER_NAMES is no obstacle's number and name"},
        {"a name of free cells",
         foreign_tiff(GDT_Byte, 1, [](GDALDataset& f) { f.SetMetadataItem("WAYBREAKER_NAMES", "0 Town"); }),
         "line 1 of its metadata item WAYBREAKER_NAMES"},
        {"a kind of no number",
         foreign_tiff(GDT_Byte, 1,
                      [](GDALDataset& f) { f.SetMetadataItem("WAYBREAKER_KINDS", "water 1\nbarrier 2x"); }),
         "line 2 of its metadata item WAYBREAKER_KINDS is no kind and the numbers of its obstacles"},
        {"a background that is none",
         foreign_tiff(GDT_Byte, 1,
                      [](GDALDataset& f) {
                          OGRSpatialReference utm;
                          utm.importFromEPSG(32633);
                          f.SetSpatialRef(&utm);
                          set_transform(f, {390000, 2, 0, 5820000, 0, -2});
                          f.SetMetadataItem("WAYBREAKER_BACKGROUND", "{}");
                      }),
         "does not begin with WKT;kind;class;name"},
    };
    for (const Case& bad : cases) {
        SCOPED_TRACE(bad.what);
        try {
            read_label_tiff(bad.bytes, "bad.tif");
            ADD_FAILURE() << "was read";
        } catch (const InputError& error) {
            const std::string message = error.what();
            EXPECT_EQ(message.find("bad.tif: "), 0U) << message;
            EXPECT_NE(message.find(bad.message), std::string::npos) << message;
            EXPECT_EQ(message.find('\n'), std::string::npos) << message;
        }
    }
}

TEST(LabelTiff, survives_being_cut_anywhere) {
    const std::string good = label_tiff_bytes(small_map());
    for (std::size_t length = 0; length < good.size(); ++length) {
        try {
            // What GDAL stores last may be missing without harm; whatever is read is the map itself.
            expect_same_obstacles(read_label_tiff(good.substr(0, length), "cut.tif").map, small_map().map);
        } catch (const InputError&) {
        }
    }
}

RC_GTEST_PROP(LabelTiff, survives_any_change_of_a_byte, ()) {
    std::string bytes = label_tiff_bytes(small_map());
    const auto changes = *rc::gen::inRange(1, 4);
    for (int i = 0; i < changes; ++i) {
        bytes[*rc::gen::inRange<std::size_t>(0, bytes.size())] = *rc::gen::arbitrary<char>();
    }
    try {
        read_label_tiff(bytes, "changed.tif");
    } catch (const InputError&) {
    }
}

}  // namespace
}  // namespace waybreaker::geo
