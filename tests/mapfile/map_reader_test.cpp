// The format of a map file is detected by content, not by name.
#include "mapfile/map_reader.hpp"

#include "ascii_map.hpp"
#include "geotiff/label_tiff.hpp"
#include "input_error.hpp"
#include "io/output_file.hpp"
#include "mapfile/digest.hpp"
#include "mapfile/grey_image.hpp"
#include "shared_data.hpp"
#include "temporary_folder.hpp"

namespace waybreaker::mapfile {
namespace {

class MapFiles : public TemporaryFolder {};

constexpr std::string_view movingai = "type octile\nheight 2\nwidth 3\nmap\n@..\n.@.\n";
constexpr std::string_view xml =
    "<root><map><title>Town</title><width>3</width><height>2</height><cellsize>5</cellsize>"
    "<startx>0</startx><starty>1</starty><grid><row>1 0 0</row><row>0 1 0</row></grid></map></root>";

TEST_F(MapFiles, OfTheMovingaiBenchmarks) {
    const io::MapFile file = read_map_file(put("some.xml", movingai));
    EXPECT_EQ(file.format, "MovingAI map");
    EXPECT_EQ(file.source, "some.xml");
    EXPECT_EQ(file.digest, sha256_digest(movingai));
    EXPECT_EQ(file.map.obstacles().size(), 2U);
    EXPECT_GT(file.label_seconds, 0);
    EXPECT_FALSE(file.task || file.georeference);
    EXPECT_EQ(read_map_file(path("some.xml"), Connectivity::eight).map.obstacles().size(), 1U);
}

TEST_F(MapFiles, OfTheAuthors) {
    for (const std::string before : {"", " \r\n", "\xEF\xBB\xBF"}) {
        const io::MapFile file = read_map_file(put("task.map", before + std::string(xml)));
        EXPECT_EQ(file.format, "authors' XML");
        EXPECT_EQ(file.annotations.title, "Town");
        EXPECT_EQ(file.cell_size, 5);
        EXPECT_EQ(file.map.obstacles().size(), 2U);
        ASSERT_TRUE(file.task);
        EXPECT_EQ(file.task->start, (Cell{0, 1}));
    }
}

TEST_F(MapFiles, WithLabels) {
    const geotiff::LabelTiff tiff{
        .map = Map::from_labels(3, 1, {7, 7, 0}), .cell_size = 2, .annotations = {.title = "Town"}};
    const std::string bytes = geotiff::label_tiff_bytes(tiff);
    const io::MapFile file = read_map_file(put("city.tif", bytes), Connectivity::eight);
    EXPECT_EQ(file.format, "GeoTIFF label map");
    EXPECT_EQ(file.digest, sha256_digest(bytes));
    EXPECT_EQ(file.annotations.title, "Town");
    EXPECT_EQ(file.cell_size, 2);
    ASSERT_EQ(file.map.obstacles().size(), 1U);
    EXPECT_EQ(file.map.obstacles()[0].cells, 2U);
}

TEST_F(MapFiles, ThatAreMasks) {
    // A label layer, for it says who its obstacle is; then the same cells with nothing said.
    const std::string labels = geotiff::label_tiff_bytes({.map = Map::from_labels(3, 1, {7, 0, 7})});
    EXPECT_EQ(read_map_file(put("labels.tif", labels)).map.obstacles().size(), 1U);
    std::string mask = labels;
    mask.replace(mask.find("WAYBREAKER_OBSTACLES"), 10, "SOMETHING_");
    const io::MapFile file = read_map_file(put("mask.tif", mask));
    EXPECT_EQ(file.format, "GeoTIFF occupancy map");
    EXPECT_EQ(file.notes.size(), 1U);  // of what is blocked
    EXPECT_EQ(file.map.obstacles().size(), 2U);
}

TEST_F(MapFiles, ThatAreImages) {
    const std::string bytes = "P2 3 2 255 0 127 128 255 0 255";
    const io::MapFile file = read_map_file(put("floor.pgm", bytes));
    EXPECT_EQ(file.format, "netpbm image");
    EXPECT_EQ(file.digest, sha256_digest(bytes));
    EXPECT_EQ(file.map.grid(), map_from_ascii("##. .#.").grid());
    EXPECT_EQ(read_map_file(path("floor.pgm"), Connectivity::four, {.threshold = 0.6}).map.grid(),
              map_from_ascii("#.. .#.").grid());
    EXPECT_EQ(read_map_file(put("floor.png", png_bytes(2, 1, {9, 200}))).format, "PNG image");
}

TEST_F(MapFiles, OfRos) {
    std::filesystem::create_directory(path("images"));
    const std::string image = "P2 3 2 255 0 205 254 254 100 254";
    put("images/floor.pgm", image);
    const std::string yaml = "resolution: 0.25\norigin: [-1, 2.5, 0]\nimage: images/floor.pgm\n";
    const io::MapFile file = read_map_file(put("floor.yaml", yaml));
    EXPECT_EQ(file.format, "ROS map");
    EXPECT_EQ(file.source, "floor.yaml");
    EXPECT_EQ(file.digest, sha256_digest(yaml + image));
    EXPECT_EQ(file.cell_size, 0.25);
    EXPECT_EQ(file.unknown, 2U);
    EXPECT_TRUE(file.notes.empty());
    EXPECT_EQ(file.map.grid(), map_from_ascii("##. .#.").grid());
    ASSERT_TRUE(file.ros);
    EXPECT_EQ(file.ros->yaml.origin, (std::array{-1.0, 2.5}));
    EXPECT_EQ(file.ros->text + file.ros->image, yaml + image);
    EXPECT_EQ(read_map_file(path("floor.yaml"), Connectivity::four, {.unknown_free = true}).map.grid(),
              map_from_ascii("#.. ...").grid());
    EXPECT_EQ(read_map_file(put("floor.yaml", yaml + "free_thresh: 0.25\n")).notes.size(), 1U);

    put("images/floor.pgm", "P2 3 2 255 0 205");
    EXPECT_NE(input_error([&] { read_map_file(path("floor.yaml")); }).find(path("images/floor.pgm")),
              std::string::npos);
    std::filesystem::remove(path("images/floor.pgm"));
    EXPECT_EQ(input_error([&] { read_map_file(path("floor.yaml")); }),
              "cannot read " + path("images/floor.pgm") + ": No such file or directory");
}

TEST_F(MapFiles, OfRosInOnePiece) {
    const std::string yaml = "resolution: 0.25\norigin: [-1, 2.5, 0]\nimage: floor.pgm";
    for (const std::string& image : {std::string("P2 3 2 255 0 205 254 254 100 254"), png_bytes(2, 1, {0, 205})}) {
        const io::MapFile file = parse_map(yaml + "\n...\n" + image, "the map");
        EXPECT_EQ(file.format, "ROS map");
        EXPECT_EQ(file.digest, sha256_digest(yaml + image)) << "as of the two files";
        EXPECT_GT(file.unknown, 0U);
        EXPECT_EQ(read_map_file(put("one.yaml", yaml + "\n...\n" + image)).digest, file.digest);
    }
    EXPECT_EQ(input_error([&] { parse_map(yaml, "the map"); }).find("the map: a ROS map is two files"), 0U);
    EXPECT_EQ(input_error([&] { parse_map(yaml + "\n...\nno image", "the map"); }).find("the map: a ROS map is two"),
              0U);
    EXPECT_THROW(parse_map(yaml + "\n...\nP2 3000 2000 255 0", "the map", Connectivity::four, {}, {.cells = 1000}),
                 SizeError);
}

constexpr std::string_view mark = "\xEF\xBB\xBF";  // before UTF-8, as some editors save it

TEST_F(MapFiles, OfTextMayBeginWithAByteOrderMark) {
    EXPECT_EQ(read_map_file(put("marked.map", std::string(mark) + std::string(movingai))).map.obstacles().size(), 2U);
    put("floor.pgm", "P2 3 1 255 0 254 0");
    const std::string yaml = "image: floor.pgm\nresolution: 0.5\norigin: [1, 2, 0]\n";
    for (const std::string& text : {yaml, std::string("{image: floor.pgm, resolution: 0.5, origin: [1, 2, 0]}\n")}) {
        const io::MapFile file = read_map_file(put("floor.yaml", std::string(mark) + text));
        EXPECT_EQ(file.format, "ROS map");
        EXPECT_EQ(file.map.obstacles().size(), 2U);
        ASSERT_TRUE(file.ros);
        EXPECT_TRUE(file.ros->text.starts_with(mark));  // it is written again as it was
    }
    EXPECT_EQ(parse_map(std::string(mark) + yaml + "...\nP2 3 1 255 0 254 0", "floor").map.obstacles().size(), 2U);
}

TEST_F(MapFiles, OfMapDataAreForImport) {
    const auto refusal = [&](std::string_view bytes) {
        return input_error([&] { read_map_file(put("city", bytes)); });
    };
    EXPECT_TRUE(refusal("<osm version='0.6'></osm>")
                    .ends_with("city: is map data (OpenStreetMap data): waybreaker import makes a map of it"));
    EXPECT_TRUE(
        refusal(R"({"type": "FeatureCollection", "features": []})").ends_with("waybreaker import makes a map of it"));
    EXPECT_TRUE(refusal("<!doctype html><html>").find("is a web page (HTML)") != std::string::npos);
    EXPECT_TRUE(refusal("").ends_with("city: is empty: has the download failed?"));
    EXPECT_TRUE(refusal("PK\x03\x04").find("is a ZIP archive: unpack it") != std::string::npos);
    EXPECT_EQ(input_error([&] { parse_map("<osm/>", "the map"); }),
              "the map: is map data (OpenStreetMap data): waybreaker import makes a map of it");
}

TEST_F(MapFiles, WithNeighboursThatGisRead) {
    const geotiff::LabelTiff plain{.map = Map::from_labels(3, 1, {7, 0, 7})};
    std::string bytes = geotiff::label_tiff_bytes(plain);
    const std::string city = put("city.tif", bytes);
    EXPECT_EQ(read_map_file(city).notes, std::vector<std::string>{});
    put("floor.png", png_bytes(2, 1, {9, 200}));
    put("floor.pgw", "0.5\n0\n0\n-0.5\n0\n0\n");
    EXPECT_EQ(read_map_file(path("floor.png")).notes.back(),
              "the world file beside it, floor.pgw, is not read: give the size of a cell in metres");
    put("city.tif.msk", "anything");
    EXPECT_NE(input_error([&] { read_map_file(city); }).find("has a mask in a file beside it, city.tif.msk"),
              std::string::npos);
}

TEST_F(MapFiles, OfImagesSayWhatIsBlocked) {
    const auto notes = [&](std::vector<std::uint8_t> greys, double threshold) {
        const std::string bytes = png_bytes(int(greys.size()), 1, greys);
        std::string text;
        for (const std::string& note : parse_map(bytes, "m", Connectivity::four, {.threshold = threshold}).notes) {
            text += note + "\n";
        }
        return text;
    };
    EXPECT_NE(notes({0, 255}, 0.5).find("greys of 0 to 127 are blocked"), std::string::npos);
    EXPECT_EQ(notes({0, 255}, 0.5).find("205"), std::string::npos);
    EXPECT_NE(notes({0, 205}, 0.5).find("205, which map savers of ROS write for unknown, is free"), std::string::npos);
    EXPECT_NE(notes({0, 205}, 0.1).find("greys of 0 to 229 are blocked"), std::string::npos);
    EXPECT_NE(notes({0, 205}, 0.1).find("for unknown, is blocked"), std::string::npos);
}

TEST_F(MapFiles, ThatAreNoneAreRefused) {
    const std::string hint =
        ": not a map that can be read: give a MovingAI map (its first line is 'type octile'), a task in the authors' "
        "XML, a GeoTIFF, the YAML of a ROS map, or an image (PNG, PGM, PBM, PPM)";
    for (const std::string_view junk : {" ", "hello\n",
                                        "\x7f"
                                        "ELF"}) {
        const std::string file = put("junk", junk);
        EXPECT_EQ(input_error([&] { read_map_file(file); }), file + hint);
    }
    const std::string tiff = put("cut.tif", std::string_view("II*\0junk", 8));
    EXPECT_EQ(input_error([&] { read_map_file(tiff); }).find(tiff + ": is no GeoTIFF map: "), 0U);
    EXPECT_EQ(input_error([&] { read_map_file(tiff); }).find("/vsimem"), std::string::npos);
    EXPECT_EQ(input_error([&] { read_map_file(put("cut.png", "\x89PNG\r\n\x1a\n")); }).find(path("cut.png")), 0U);
    EXPECT_EQ(input_error([&] { read_map_file(path(".")); }),
              "cannot read " + path(".") + ": it is a folder; give a file");
    EXPECT_EQ(input_error([&] { read_map_file(path("none")); }),
              "cannot read " + path("none") + ": No such file or directory");
}

TEST_F(MapFiles, OfThePaperAreReadAll) {
    const auto shared = shared_folder();
    if (!shared) GTEST_SKIP() << no_shared_folder;
    const auto files = files_of(*shared / "data" / "paper-grids", ".xml");
    EXPECT_EQ(files.size(), 3U);
    for (const auto& path : files) {
        const io::MapFile file = read_map_file(path.string());
        EXPECT_EQ(file.map.width(), 501) << path;
        EXPECT_EQ(file.map.height(), 501) << path;
        const std::string bytes = io::read_whole(path.string());
        const std::string_view grid = std::string_view(bytes).substr(bytes.find("<grid>"));
        const auto blocked = std::count(grid.begin(), grid.begin() + std::ptrdiff_t(grid.find("</grid>")), '1');
        std::uint64_t cells = 0;
        for (const Obstacle& obstacle : file.map.obstacles()) cells += obstacle.cells;
        EXPECT_EQ(cells, std::uint64_t(blocked)) << path;
        ASSERT_TRUE(file.task && file.task->start && file.task->goal) << path;
        EXPECT_FALSE(file.map.grid().blocked(*file.task->start)) << path;
        EXPECT_FALSE(file.map.grid().blocked(*file.task->goal)) << path;
    }
}

}  // namespace
}  // namespace waybreaker::mapfile
