// Label maps survive their file format, and GDAL's own tools.
#include "geotiff/label_tiff.hpp"

#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "geotiff/written_tiff.hpp"
#include "input_error.hpp"

namespace waybreaker::geotiff {
namespace {

TEST(LabelTiff, comes_back_whole) {
    const LabelTiff written = small_map();
    const LabelTiff read = read_label_tiff(label_tiff_bytes(written), "city.tif");
    expect_same_obstacles(written.map, read.map);
    EXPECT_EQ(read.cell_size, 2.4);
    EXPECT_EQ(read.annotations.attribution, written.annotations.attribution);
    EXPECT_EQ(read.annotations.title, written.annotations.title);
    EXPECT_EQ(read.annotations.names, written.annotations.names);
    EXPECT_EQ(read.annotations.kinds, written.annotations.kinds);
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
        EXPECT_EQ(read.annotations.attribution, original.annotations.attribution);
        EXPECT_EQ(read.annotations.title, original.annotations.title);
        EXPECT_EQ(read.annotations.names, original.annotations.names);
        EXPECT_EQ(read.annotations.kinds, original.annotations.kinds);
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
    EXPECT_EQ(tiff.annotations.names, (site::ObstacleNames{"", "", "7"}));
    EXPECT_EQ(tiff.annotations.kinds, (site::ObstacleKinds{Kind::unknown, Kind::water, Kind::barrier}));
    EXPECT_EQ(tiff.annotations.sections, (site::Sections{small_map().annotations.sections.structures, {{}, {}, {1}}}));
}

TEST(LabelTiff, keeps_cells_where_they_are) {
    LabelTiff tiff = small_map();
    tiff.annotations.bridges = {{{0, 0}, 1}, {{1, 2}, 3}};
    tiff.annotations.ways = {{{0, 0}, 2}, {{3, 0}, 1}, {{1, 2}, 3}};
    tiff.annotations.unknown = {{{2, 1}, 1}};
    const std::string bytes = label_tiff_bytes(tiff);
    const site::Annotations read = read_label_tiff(bytes, "city.tif").annotations;
    EXPECT_EQ(read.bridges, tiff.annotations.bridges);
    EXPECT_EQ(read.ways, tiff.annotations.ways);
    EXPECT_EQ(read.unknown, tiff.annotations.unknown);
    const auto ways = [&bytes](const std::vector<const char*>& arguments) {
        return read_label_tiff(translated(bytes, arguments), "piece.tif").annotations.ways;
    };
    EXPECT_EQ(ways({"-srcwin", "2", "1", "3", "3"}), (std::vector<site::CellRun>{{{0, 1}, 2}}));
    EXPECT_EQ(ways({"-srcwin", "0", "0", "2", "1"}), (std::vector<site::CellRun>{{{0, 0}, 2}}));
    EXPECT_TRUE(ways({"-r", "nearest", "-outsize", "200%", "200%"}).empty());  // other cells
    EXPECT_EQ(ways({"-mo", "WAYBREAKER_WAYS=390000.25 5820000.75 2.4\n1 2 3"}),
              (std::vector<site::CellRun>{{{1, 2}, 3}}));
}

RC_GTEST_PROP(LabelTiff, keepsAnyCells, ()) {
    const int side = *rc::gen::inRange(1, 400);
    LabelTiff tiff{.map = Map(Grid(side, side)), .cell_size = 2.4, .georeference = small_map().georeference};
    std::vector<site::CellRun>& ways = tiff.annotations.ways;
    for (int y = *rc::gen::inRange(0, side); y < side; y += *rc::gen::inRange(1, 100)) {
        for (int x = *rc::gen::inRange(0, side); x < side;) {
            const int length = *rc::gen::inRange(1, side - x + 1);
            ways.push_back({{x, y}, length});
            x += length + *rc::gen::inRange(1, 200);
        }
    }
    RC_ASSERT(read_label_tiff(label_tiff_bytes(tiff), "city.tif").annotations.ways == ways);
}

TEST(LabelTiff, refuses_cells_that_are_none) {
    const std::string bytes = label_tiff_bytes(small_map());
    const std::string place = "390000.25 5820000.75 2.4\n";
    for (const std::string& text :
         {std::string("x"), std::string("1 2 0"), place + "1 2", place + "1 2 0", place + "-1 2 1", place + "1 2 3 4",
          place, place + "00", place + "789c", place + "789c636060000000030001"}) {
        const std::string item = "WAYBREAKER_BRIDGES=" + text;
        const std::string error = input_error([&] {
            read_label_tiff(translated(bytes, {"-mo", item.c_str()}), "city.tif");
        });
        EXPECT_NE(error.find("city.tif: its metadata item WAYBREAKER_BRIDGES"), std::string::npos) << text;
    }
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
        return read_label_tiff(bytes, "city.tif").annotations.names;
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
        return read_label_tiff(bytes, "city.tif").annotations.kinds;
    };
    EXPECT_EQ(kinds("water 6 70000\nbarrier 5"), (site::ObstacleKinds{Kind::unknown, Kind::water, Kind::barrier}));
    EXPECT_EQ(kinds("swamp 70000\ncliff 5\n"), (site::ObstacleKinds{Kind::unknown, Kind::unknown, Kind::cliff}));
    EXPECT_EQ(kinds("swamp 70000"), site::ObstacleKinds{});
    EXPECT_EQ(kinds(""), site::ObstacleKinds{});
}

TEST(LabelTiff, keeps_notes_line_by_line) {
    LabelTiff written = small_map();
    written.annotations.notes = {"Vltava: closed along the edge of the data", "two\nlines", "", " \x1b[31mred\x07 "};
    const std::string bytes = label_tiff_bytes(written);
    const std::vector<std::string> clean{"Vltava: closed along the edge of the data", "two lines", "[31mred"};
    EXPECT_EQ(read_label_tiff(bytes, "city.tif").annotations.notes, clean);
    const std::string piece = translated(bytes, {"-srcwin", "2", "0", "3", "3"});
    EXPECT_EQ(read_label_tiff(piece, "piece.tif").annotations.notes, clean);
}

TEST(LabelTiff, has_notes_of_strangers_as_printable_lines) {
    const std::string text = "\n a \x1b[2J\r\n\n\xff\xfe\n" + std::string(1000, 'x');
    const std::string bytes = foreign_tiff(GDT_UInt32, 1, [&text](GDALDataset& f) {
        write_cells(f, std::vector<std::int32_t>(32, 3));
        f.SetMetadataItem("WAYBREAKER_NOTES", text.c_str());
    });
    EXPECT_EQ(read_label_tiff(bytes, "city.tif").annotations.notes,
              (std::vector<std::string>{"a [2J", "??", std::string(250, 'x')}));
}

}  // namespace
}  // namespace waybreaker::geotiff
