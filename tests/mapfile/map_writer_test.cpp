// Maps in every format that is written come back as they were, as far as the format goes; what is lost is said.
#include "mapfile/map_writer.hpp"

#include <gtest/gtest.h>
#include <png.h>

#include "ascii_map.hpp"
#include "city/city_import.hpp"
#include "input_error.hpp"
#include "io/output_file.hpp"
#include "io/shortest_text.hpp"
#include "mapfile/grey_image.hpp"
#include "mapfile/map_reader.hpp"
#include "mapfile/occupancy.hpp"
#include "mapfile/relabelled_map.hpp"
#include "mapfile/ros_map.hpp"
#include "project_folder.hpp"
#include "shared_data.hpp"
#include "temporary_folder.hpp"
#include "waybreaker/planner.hpp"

namespace waybreaker::mapfile {
namespace {

class WrittenMaps : public TemporaryFolder {
  protected:
    WrittenMap write(const io::MapFile& map, const std::string& name) const {
        WrittenMap written = write_map(map, path(name));
        for (const io::OutputFile& file : written.files) io::write_whole(file.path, file.bytes);
        return written;
    }
};

constexpr std::string_view yard = R"(
    .aab.
    ..ab#
    ..c.#)";

io::MapFile labelled_yard() {
    const Map drawn = map_from_ascii(yard);
    std::vector<ObstacleAttributes> attributes(drawn.obstacles().size() + 1);
    attributes[2] = {.destructible = false, .source_id = -4711};
    return {.map = Map::from_labels(5, 3, {drawn.labels().begin(), drawn.labels().end()}, attributes),
            .cell_size = 2.5,
            .origin = std::array{100.0, 42.5},
            .annotations = {.title = "Yard", .attribution = "(c) somebody"}};
}

TEST_F(WrittenMaps, ComeBackWithTheirCells) {
    const io::MapFile map = labelled_yard();
    for (const char* name : {"y.map", "y.xml", "y.tif", "y.tiff", "y.yaml", "y.yml", "y.png", "y.pgm"}) {
        write(map, name);
        const io::MapFile back = read_map_file(path(name));
        EXPECT_EQ(back.map.grid(), map.map.grid()) << name;
        // And from there the same bytes.
        const auto again = std::filesystem::path("again").replace_extension(std::filesystem::path(name).extension());
        const WrittenMap twice = write_map(back, path(again));
        EXPECT_EQ(twice.files.front().bytes, write_map(map, path(again)).files.front().bytes) << name;
    }
}

TEST_F(WrittenMaps, KeepWhatTheirFormatHolds) {
    const io::MapFile map = labelled_yard();
    write(map, "y.tif");
    const io::MapFile tiff = read_map_file(path("y.tif"));
    EXPECT_TRUE(std::equal(tiff.map.labels().begin(), tiff.map.labels().end(), map.map.labels().begin()));
    EXPECT_EQ(tiff.map.obstacles()[1].source_id, -4711);
    EXPECT_FALSE(tiff.map.obstacles()[1].destructible);
    EXPECT_EQ(tiff.annotations.title, "Yard");
    EXPECT_EQ(tiff.annotations.attribution, "(c) somebody");

    write(map, "y.yaml");
    const io::MapFile ros = read_map_file(path("y.yaml"));
    EXPECT_EQ(ros.cell_size, 2.5);
    ASSERT_TRUE(ros.ros);
    EXPECT_EQ(ros.ros->yaml.origin, (std::array{100.0, 42.5}));  // lower left: 3 cells of 2.5 below the top

    write(map, "y.xml");
    EXPECT_EQ(read_map_file(path("y.xml")).cell_size, 2.5);
    EXPECT_EQ(read_map_file(path("y.xml")).annotations.title, "Yard");
}

TEST_F(WrittenMaps, KeepATask) {
    io::MapFile map = labelled_yard();
    map.task = io::MapTask{.start = Cell{0, 0},
                           .goal = Cell{4, 0},
                           .search = {.planner = Algorithm::jps, .heuristic = Heuristic::octile, .weight = 1.25}};
    map.task->search.body.corners = Corners::cut;
    map.task->search.tie_break = TieBreak::g_min;
    write(map, "y.xml");
    const io::MapTask task = *read_map_file(path("y.xml")).task;
    EXPECT_EQ(task.start, (Cell{0, 0}));
    EXPECT_EQ(task.goal, (Cell{4, 0}));
    EXPECT_EQ(task.search.planner, Algorithm::jps);
    EXPECT_EQ(task.search.heuristic, Heuristic::octile);
    EXPECT_EQ(task.search.weight, 1.25);
    EXPECT_EQ(task.search.tie_break, TieBreak::g_min);
    EXPECT_EQ(task.search.body.corners, Corners::cut);
    EXPECT_TRUE(task.search.diagonal);
}

TEST_F(WrittenMaps, SayWhatIsLost) {
    const io::MapFile map = labelled_yard();
    EXPECT_EQ(write_map(map, "y.tif").losses, std::vector<std::string>());
    EXPECT_EQ(write_map(map, "y.map").losses,
              (std::vector<std::string>{
                  "a MovingAI map does not hold that its 4 obstacles are not the 1 connected ones, source ids, which "
                  "obstacles cannot be destroyed",
                  "a MovingAI map does not hold the size of a cell",
                  "a MovingAI map does not hold the origin of the map",
                  "a MovingAI map does not hold the title",
                  "a MovingAI map does not hold the attribution, which must go with it: (c) somebody",
              }));
    const io::MapFile plain{.map = map_from_ascii("..#..")};
    for (const char* name : {"y.map", "y.xml", "y.tif", "y.yaml", "y.png", "y.pgm"}) {
        EXPECT_EQ(write_map(plain, name).losses, std::vector<std::string>()) << name;
    }
}

// Names and what lies around go with a map, as far as its format takes them.
TEST_F(WrittenMaps, AreStillKnownByTheirNames) {
    const io::MapFile city = read_map_file(project_folder() / "data" / "berlin-mitte.tif");
    ASSERT_EQ(site::name_count(city.annotations.names), 814U);
    ASSERT_FALSE(city.annotations.background.features.empty());
    EXPECT_TRUE(write(city, "b.tif").losses.empty());
    EXPECT_EQ(bytes_of("b.tif"), bytes_of(project_folder() / "data" / "berlin-mitte.tif"));

    const std::string ground = "does not hold streets, water and what else lies around the obstacles";
    EXPECT_EQ(write(city, "b.geojson").losses,
              (std::vector<std::string>{"a GeoJSON does not hold the size of a cell", "a GeoJSON " + ground,
                                        "a GeoJSON does not hold whom the map was made for",
                                        "a GeoJSON does not hold which cells are ways and bridges",
                                        "a GeoJSON does not hold the notes"}));
    city::ImportOptions all_of_it{.longitude = 13.383, .latitude = 52.5213};
    all_of_it.choice.obstacles = {{.key = "*"}};
    const geotiff::LabelTiff imported = city::import_city(path("b.geojson"), all_of_it).tiff;
    EXPECT_TRUE(imported.map.grid() == city.map.grid());
    EXPECT_EQ(imported.annotations.names, city.annotations.names);

    const std::vector<std::string> losses = write_map(city, "b.png").losses;
    EXPECT_NE(losses.front().find("source ids, names"), std::string::npos) << losses.front();
    EXPECT_NE(std::find(losses.begin(), losses.end(), "a PNG " + ground), losses.end());
}

TEST_F(WrittenMaps, HaveAFormatByName) {
    const io::MapFile plain{.map = map_from_ascii("..#..")};
    for (const char* name : {"y", "y.jpg", "y.MAP", "map", ".map"}) {
        EXPECT_NE(input_error([&] { write_map(plain, name); }).find(std::string(name) + ": the name says no format"),
                  std::string::npos)
            << name;
    }
}

// Saved by ROS, read, planned on, and written where it then is called the same: not a byte differs.
TEST_F(WrittenMaps, OfRosAreTheSameToTheByte) {
    const std::string image = std::string("P5\n# CREATOR: map_saver.cpp 0.050 m/pix\n4 3\n255\n") +
                              "\xCD\xFE\xFE\xFE\xCD\xFE" + std::string("\0", 1) + "\xFE\xCD\xFE\xFE\xFE";
    const std::string yaml =
        "image: floor.pgm\nresolution: 0.050000\norigin: [-12.200000, -7.500000, 0.000000]\nnegate: 0\n"
        "occupied_thresh: 0.65\nfree_thresh: 0.196\n\n";
    std::filesystem::create_directory(path("out"));
    put("floor.pgm", image);
    const io::MapFile map = read_map_file(put("floor.yaml", yaml));
    const Plan plan = Planner().plan(map.map, ground_and_air({1, 0}, {3, 2}));
    ASSERT_EQ(plan.status, PlanStatus::solved);
    EXPECT_TRUE(write(map, "out/floor.yaml").losses.empty());
    EXPECT_EQ(bytes_of("out/floor.pgm"), image);
    EXPECT_EQ(bytes_of("out/floor.yaml"), yaml);

    write(map, "out/hall.yaml");
    EXPECT_EQ(bytes_of("out/hall.pgm"), image);
    EXPECT_EQ(bytes_of("out/hall.yaml"), "image: hall.pgm" + yaml.substr(16));
}

// A robot's map keeps its place in the robot's frame by way of a label map, where its walls get names and prices.
TEST_F(WrittenMaps, KeepTheOriginOfARobotsFrame) {
    for (const std::array<double, 2> origin :
         {std::array{-12.2, -7.5}, {0.1, 0.2}, {0.0, -1.5}, {51234.567891, 1e-3}}) {
        const std::string yaml = "image: floor.pgm\nresolution: 0.05\norigin: [" + io::shortest_text(origin[0]) + ", " +
                                 io::shortest_text(origin[1]) + ", 0]\n";
        put("floor.pgm", "P2 4 3 255 254 254 0 254  254 254 0 254  254 0 254 254");
        write(read_map_file(put("floor.yaml", yaml)), "floor.tif");
        const io::MapFile tiff = read_map_file(path("floor.tif"));
        EXPECT_EQ(tiff.cell_size, 0.05);
        EXPECT_EQ(tiff.origin, origin);
        EXPECT_TRUE(write(tiff, "back.yaml").losses.empty());
        const io::MapFile back = read_map_file(path("back.yaml"));
        EXPECT_EQ(back.origin, origin);
        EXPECT_EQ(back.map.grid(), tiff.map.grid());
    }
}

// What is opened is free, and nothing else changes: unknown stays unknown, half occupied half occupied.
TEST_F(WrittenMaps, OfRosWithoutObstacles) {
    const std::string walls = "P2 5 2 255 0 254 205 254 100  0 254 205 254 100";
    put("floor.pgm", walls);
    constexpr io::Nav2 nav2 = io::Nav2::jazzy;
    for (const std::string mode : {"trinary", "scale", "raw"}) {
        SCOPED_TRACE(mode);
        put("floor.yaml", "image: floor.pgm\nmode: " + mode + "\nresolution: 0.05\norigin: [-1.5, 2, 0]\n");
        const io::MapFile before = read_map_file(path("floor.yaml"));
        const ObstacleId wall = before.map.obstacle_at(mode == "raw" ? Cell{4, 0} : Cell{0, 0});
        ASSERT_TRUE(before.map.obstacle(wall).destructible);
        EXPECT_TRUE(write_map(without_obstacles(before, std::array{wall}), "x.yaml").losses.empty());
        write(without_obstacles(before, std::array{wall}), "opened.yaml");
        const io::MapFile after = read_map_file(path("opened.yaml"));
        EXPECT_EQ(after.origin, before.origin);
        EXPECT_EQ(after.cell_size, before.cell_size);
        EXPECT_EQ(after.unknown, before.unknown);
        const GreyImage image = read_image(before.ros->image, "before");
        const GreyImage opened = read_image(after.ros->image, "after");
        for (std::size_t i = 0; i < image.pixels.size(); ++i) {
            const auto expected = before.map.labels()[i] == wall.value
                                      ? std::optional(0)
                                      : occupancy(image.pixels[i], false, before.ros->yaml, nav2);
            EXPECT_EQ(occupancy(opened.pixels[i], false, after.ros->yaml, nav2), expected) << i;
        }
    }
}

// One row of pixels, each its grey and how opaque it is.
std::string grey_alpha_png(const std::vector<std::array<std::uint8_t, 2>>& pixels) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = png_uint_32(pixels.size());
    image.height = 1;
    image.format = PNG_FORMAT_GA;
    std::string bytes(PNG_IMAGE_PNG_SIZE_MAX(image), '\0');
    png_alloc_size_t size = bytes.size();
    EXPECT_NE(png_image_write_to_memory(&image, bytes.data(), &size, 0, pixels.data(), 0, nullptr), 0);
    bytes.resize(size);
    return bytes;
}

// What was read as Humble does is written so: its transparent wall stays one, and both releases read what is written.
TEST_F(WrittenMaps, OfRosWithoutObstaclesHoldWhatWasRead) {
    put("floor.png", grey_alpha_png({{0, 255}, {255, 255}, {0, 0}}));
    put("floor.yaml", "image: floor.png\nresolution: 0.05\norigin: [0, 0, 0]\n");
    for (const io::Nav2 nav2 : {io::Nav2::jazzy, io::Nav2::humble}) {
        const io::MapFile before = read_map_file(path("floor.yaml"), Connectivity::four, {.nav2 = nav2});
        EXPECT_EQ(before.unknown, nav2 == io::Nav2::humble ? 0U : 1U);
        write(without_obstacles(before, std::array{ObstacleId{1}}), "opened.yaml");
        for (const io::Nav2 reader : {io::Nav2::jazzy, io::Nav2::humble}) {
            const io::MapFile after = read_map_file(path("opened.yaml"), Connectivity::four, {.nav2 = reader});
            EXPECT_EQ(after.unknown, before.unknown);
            EXPECT_EQ(after.map.grid(), map_from_ascii("..#").grid());
        }
    }
}

TEST_F(WrittenMaps, WithoutObstaclesKeepTheOthers) {
    io::MapFile map = labelled_yard();
    map.annotations.names = {"", "Shed", "Barn", "", "Wall"};
    using Kind = site::ObstacleKind;
    map.annotations.kinds = {Kind::unknown, Kind::building, Kind::building, Kind::water, Kind::barrier};
    const io::MapFile opened = without_obstacles(map, std::array{ObstacleId{1}});
    EXPECT_EQ(opened.map.grid(), map_from_ascii("...#. ...## ..#.#").grid());
    ASSERT_EQ(opened.map.obstacles().size(), 3U);
    EXPECT_EQ(opened.map.obstacles()[0].source_id, -4711);
    EXPECT_EQ(opened.annotations.names, (site::ObstacleNames{"", "Barn", "", "Wall"}));
    EXPECT_EQ(opened.annotations.kinds,
              (site::ObstacleKinds{Kind::unknown, Kind::building, Kind::water, Kind::barrier}));
    EXPECT_EQ(input_error([&] { without_obstacles(map, std::array{ObstacleId{5}}); }),
              "there is no obstacle 5: the map has 4 obstacles");
    EXPECT_EQ(input_error([&] { without_obstacles(map, std::array{ObstacleId{2}}); }),
              "obstacle 2 cannot be destroyed");
}

TEST_F(WrittenMaps, OfCitiesComeBack) {
    const auto shared = shared_folder();
    if (!shared) GTEST_SKIP() << no_shared_folder;
    const std::string city = (*shared / "data" / "cities" / "Berlin_0_512.map").string();
    const io::MapFile map = read_map_file(city);
    for (const char* name : {"b.map", "b.xml", "b.tif", "b.yaml", "b.png", "b.pgm"}) {
        write(map, name);
        EXPECT_EQ(read_map_file(path(name)).map.grid(), map.map.grid()) << name;
    }
}

TEST_F(WrittenMaps, KeepTheirSectionsInLabels) {
    const io::MapFile cut = in_sections(labelled_yard(), {.side = 2});
    write(cut, "cut.tif");
    const io::MapFile back = read_map_file(path("cut.tif"));
    EXPECT_TRUE(std::equal(cut.map.labels().begin(), cut.map.labels().end(), back.map.labels().begin()));
    EXPECT_EQ(back.annotations.sections, cut.annotations.sections);
    // Opened, those that are left are still parts of what they were.
    const ObstacleId first = back.map.obstacle_at({1, 0});
    const ObstacleId second = back.map.obstacle_at({2, 0});
    const io::MapFile opened = without_obstacles(back, std::array{first});
    EXPECT_EQ(opened.annotations.sections.parts[opened.map.obstacle_at({2, 0}).value],
              back.annotations.sections.parts[second.value]);
    EXPECT_EQ(input_error([&] { in_sections(back, {.side = 2}); }),
              "cut.tif: is cut into sections already; give the map that it was made from");
}

}  // namespace
}  // namespace waybreaker::mapfile
