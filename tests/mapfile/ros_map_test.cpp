// ROS maps: which cells block, and the YAML beside the image.
#include "mapfile/ros_map.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "ascii_map.hpp"
#include "input_error.hpp"

namespace waybreaker::mapfile {
namespace {

GreyImage grey_image(int width, int height, const std::vector<int>& greys) {
    GreyImage image{width, height, false, {}};
    for (const int grey : greys) image.pixels.push_back(GreyImage::Pixel::of_grey(grey));
    return image;
}

// What map savers write for unknown comes back as free where the threshold is not theirs.
TEST(RosMaps, GreyOf205IsATrap) {
    const GreyImage image = grey_image(3, 1, {205, 255, 0});
    EXPECT_EQ(ros_cells(image, {.free_thresh = 0.196}, 1).unknown_count, 1U);
    EXPECT_EQ(ros_cells(image, {.free_thresh = 0.25}, 1).unknown_count, 0U);
    EXPECT_FALSE(ros_cells(image, {.free_thresh = 0.196}, 1).frees_unknown);
    EXPECT_TRUE(ros_cells(image, {.free_thresh = 0.25}, 1).frees_unknown);
}

// YAML on one line, and JSON, which is YAML as well.
TEST(RosMaps, MayStandInBraces) {
    for (const std::string text : {"{image: hall.pgm, resolution: 0.5, origin: [-4.0, -3.0, 0.0], negate: 0}",
                                   " {\n\"image\": \"hall.pgm\", \"resolution\": 0.5, \"origin\": [-4, -3, 0]}\n"}) {
        SCOPED_TRACE(text);
        EXPECT_TRUE(is_ros_yaml(text));
        const io::RosYaml yaml = parse_ros_yaml(text, "hall.yaml");
        EXPECT_EQ(yaml.image, "hall.pgm");
        EXPECT_EQ(yaml.origin[1], -3);
        EXPECT_EQ(parse_ros_yaml(with_image(text, "other.pgm", "hall.yaml"), "").image, "other.pgm");
    }
    EXPECT_FALSE(is_ros_yaml("{\"format\": \"waybreaker-mission/1\", \"agents\": []}"));
}

TEST(RosMaps, BlockWhatIsOccupiedAndUnknown) {
    const GreyImage image = grey_image(5, 1, {0, 100, 150, 205, 255});
    const auto cells = [&](io::RosMode mode, double threshold, bool unknown_free) {
        return ros_map(ros_cells(image, {.mode = mode}, threshold), Connectivity::four, unknown_free).grid();
    };
    EXPECT_EQ(cells(io::RosMode::trinary, 1, false), map_from_ascii("####.").grid());
    EXPECT_EQ(cells(io::RosMode::trinary, 1, true), map_from_ascii("#....").grid());
    EXPECT_EQ(cells(io::RosMode::scale, 1, false), map_from_ascii("#....").grid());
    EXPECT_EQ(cells(io::RosMode::scale, 0.9, false), map_from_ascii("##...").grid());
    EXPECT_EQ(cells(io::RosMode::raw, 1, false), map_from_ascii(".####").grid());
    EXPECT_EQ(cells(io::RosMode::raw, 1, true), map_from_ascii(".#...").grid());
    EXPECT_EQ(ros_cells(image, {}, 1).unknown_count, 3U);
}

// It is unknown what unknown cells hold: they cannot be removed, and are not merged with a wall they touch.
TEST(RosMaps, UnknownIsNoWall) {
    const std::string_view picture = R"(
        ##uu.
        #.u.#
        ..uuu)";
    GreyImage image{5, 3, false, {}};
    for (const std::string& row : ascii_rows(picture)) {
        for (const char c : row) {
            image.pixels.push_back(GreyImage::Pixel::of_grey(c == '#' ? 0 : c == 'u' ? 205 : 255));
        }
    }
    for (const io::RosMode mode : {io::RosMode::trinary, io::RosMode::scale, io::RosMode::raw}) {
        SCOPED_TRACE(int(mode));
        GreyImage seen = image;
        io::RosYaml yaml{.mode = mode};
        for (GreyImage::Pixel& pixel : seen.pixels) {
            const int grey = pixel.luma;
            if (mode == io::RosMode::scale && grey == 205) pixel.alpha = 0;
            if (mode == io::RosMode::raw) pixel = GreyImage::Pixel::of_grey(grey == 205 ? 255 : grey == 0 ? 100 : 0);
        }
        seen.transparency = mode == io::RosMode::scale;
        const Map map = ros_map(ros_cells(seen, yaml, 1), Connectivity::four, false);
        EXPECT_EQ(map.grid(), map_from_ascii("####. #.#.# ..###").grid());
        ASSERT_EQ(map.obstacles().size(), 3U);
        const Obstacle& wall = map.obstacle(map.obstacle_at({0, 0}));
        const Obstacle& unseen = map.obstacle(map.obstacle_at({2, 0}));
        const Obstacle& pillar = map.obstacle(map.obstacle_at({4, 1}));
        EXPECT_EQ(wall.cells, 3U);
        EXPECT_TRUE(wall.destructible);
        EXPECT_EQ(unseen.cells, 6U);
        EXPECT_FALSE(unseen.destructible);
        EXPECT_EQ(pillar.cells, 1U);
        EXPECT_TRUE(pillar.destructible);
        EXPECT_EQ(ros_map(ros_cells(seen, yaml, 1), Connectivity::four, true).obstacles().size(), 2U);
    }
}

// A transparent black pixel: a wall to Humble, unknown since.
TEST(RosMaps, AreReadAsTheChosenNav2Does) {
    GreyImage image = grey_image(2, 1, {0, 0});
    image.transparency = true;
    image.pixels[1].alpha = 0;
    EXPECT_EQ(ros_cells(image, {}, 1).unknown_count, 1U);
    EXPECT_EQ(ros_cells(image, {}, 1, io::Nav2::humble).unknown_count, 0U);
}

TEST(RosMaps, UnknownIsLabelledAsWallsAre) {
    const GreyImage image = grey_image(2, 2, {205, 255, 255, 205});
    EXPECT_EQ(ros_map(ros_cells(image, {}, 1), Connectivity::four, false).obstacles().size(), 2U);
    EXPECT_EQ(ros_map(ros_cells(image, {}, 1), Connectivity::eight, false).obstacles().size(), 1U);
}

constexpr const char* saved =
    "image: floor.pgm\nresolution: 0.050000\norigin: [-12.200000, -7.500000, 0.000000]\nnegate: 0\n"
    "occupied_thresh: 0.65\nfree_thresh: 0.196\n\n";

TEST(RosMaps, YamlIsRead) {
    const io::RosYaml yaml = parse_ros_yaml(saved, "floor.yaml");
    EXPECT_EQ(yaml.image, "floor.pgm");
    EXPECT_EQ(yaml.resolution, 0.05);
    EXPECT_EQ(yaml.origin, (std::array{-12.2, -7.5}));
    EXPECT_EQ(yaml.mode, io::RosMode::trinary);
    const io::RosYaml other = parse_ros_yaml(
        "# by hand\nmode: raw\nimage: \"my floor.png\"\nresolution: 1\norigin: [0, 0]\nnegate: 1\n", "floor.yaml");
    EXPECT_EQ(other.image, "my floor.png");
    EXPECT_EQ(other.mode, io::RosMode::raw);
    EXPECT_TRUE(other.negate);
    EXPECT_EQ(other.free_thresh, 0.196);
}

// Some write every line indented, which YAML allows.
TEST(RosMaps, YamlMayBeIndented) {
    const std::string text = "  # mine\n  resolution: 1\n  image: a.pgm\n  origin: [0, 0, 0]\n";
    EXPECT_TRUE(is_ros_yaml(text));
    EXPECT_EQ(parse_ros_yaml(text, "y").image, "a.pgm");
    std::string other = text;
    other.replace(other.find("a.pgm"), 5, "b.pgm");
    EXPECT_EQ(with_image(text, "b.pgm", "y"), other);
    EXPECT_TRUE(is_ros_yaml("\timage: a"));
    EXPECT_FALSE(is_ros_yaml("the image: a"));
    EXPECT_FALSE(is_ros_yaml("\n\n"));
}

// Nothing turns by a full turn, nor by what is left of one when it is rounded.
TEST(RosMaps, YawThatTurnsNothingIsRead) {
    const auto yaml = [](const std::string& yaw) {
        return parse_ros_yaml("image: a.pgm\nresolution: 1\norigin: [3, 4, " + yaw + "]\n", "y");
    };
    for (const char* yaw : {"0", "-0.0", "1e-12", "-1e-7", "6.283185307179586", "6.283185", "-12.566370614359172"}) {
        SCOPED_TRACE(yaw);
        EXPECT_EQ(yaml(yaw).origin, (std::array{3.0, 4.0}));
    }
    for (const char* yaw : {"1e-5", "-0.001", "1.5707963", "3.14159265", "6.28", "6.2832"}) {
        SCOPED_TRACE(yaw);
        EXPECT_NE(input_error([&] { yaml(yaw); }).find("y:3: origin has a yaw"), std::string::npos);
    }
}

TEST(RosMaps, YamlNamesAnotherImageAndNothingElseChanges) {
    EXPECT_EQ(with_image(saved, "floor.pgm", "y"), saved);
    EXPECT_EQ(with_image(saved, "hall.pgm", "y"), "image: hall.pgm" + std::string(saved).substr(16));
    const std::string rest = "  # here\nresolution: 1\norigin: [0, 0, 0]\n";
    EXPECT_EQ(with_image("image: \"a b.pgm\"" + rest, "c.pgm", "y"), "image: \"c.pgm\"" + rest);
    // An escaped name: then the file is written from scratch.
    EXPECT_EQ(parse_ros_yaml(with_image("image: \"a\\x62.pgm\"" + rest, "c.pgm", "y"), "y").image, "c.pgm");
    EXPECT_EQ(parse_ros_yaml(with_image("image: &i im\nnote: im" + rest, "c: d.pgm", "y"), "y").image, "c: d.pgm");
}

RC_GTEST_PROP(RosMaps, YamlComesBack, ()) {
    const auto share = [] { return *rc::gen::inRange(0, 100000) / 99999.0; };
    io::RosYaml yaml;
    yaml.image = *rc::gen::element<std::string>("floor.pgm", "a b.png", "yes", "7", "it's.pgm", "#1.pgm", "x: y.pgm");
    yaml.mode = *rc::gen::element(io::RosMode::trinary, io::RosMode::scale, io::RosMode::raw);
    yaml.resolution = 0.01 + share();
    yaml.origin = {share() - 0.5, -1000 * share()};
    yaml.negate = *rc::gen::arbitrary<bool>();
    yaml.free_thresh = share() / 2;
    yaml.occupied_thresh = 1 - share() / 2;
    const io::RosYaml read = parse_ros_yaml(ros_yaml_text(yaml), "floor.yaml");
    RC_ASSERT(read.image == yaml.image && read.mode == yaml.mode && read.resolution == yaml.resolution);
    RC_ASSERT(read.origin == yaml.origin && read.negate == yaml.negate);
    RC_ASSERT(read.free_thresh == yaml.free_thresh && read.occupied_thresh == yaml.occupied_thresh);
}

TEST(RosMaps, YamlThatIsNoneIsRefused) {
    const std::string start = "image: a.pgm\nresolution: 1\norigin: [0, 0, 0]\n";
    const std::vector<std::pair<std::string, std::string>> cases{
        {"", "y: is no YAML of a ROS map"},
        {"- image: a", "is no YAML of a ROS map"},
        {"image: [", "not well-formed YAML"},
        {"image: \"\\\1\"", "not well-formed YAML: unknown escape character: ?"},
        {"image: a.pgm\nresolution: 1\n", "origin is missing"},
        {"image: a.pgm\norigin: [0, 0, 0]\n", "resolution is missing"},
        {"resolution: 1\norigin: [0, 0, 0]\n", "image is missing"},
        {"image: {}\nresolution: 1\norigin: [0, 0, 0]\n", "y:1: image must be the name of a file"},
        {"image: a.pgm\nresolution: 0\norigin: [0, 0, 0]\n", "y:2: resolution must be a number"},
        {"image: a.pgm\nresolution: .nan\norigin: [0, 0, 0]\n", "y:2: resolution must be a number"},
        {"image: a.pgm\nresolution: 1\norigin: [0, 0, 1.57]\n", "y:3: origin has a yaw"},
        {"image: a.pgm\nresolution: 1\norigin: [0]\n", "y:3: origin must be [x, y, yaw]"},
        {"image: a.pgm\nresolution: 1\norigin: [a, 0, 0]\n", "the x of origin must be a number"},
        {start + "mode: binary\n", "y:4: mode is 'binary'"},
        {start + "negate: 2\n", "y:4: negate is '2'"},
        {start + "occupied_thresh: 65\n", "y:4: occupied_thresh must be a number from 0 to 1"},
        {start + "free_thresh: 0.7\n", "free_thresh is above occupied_thresh"},
        {std::string(100000, '['), "too long"},
        {std::string(20000, '['), "not well-formed YAML"},
    };
    for (const auto& [text, message] : cases) {
        const std::string error = input_error([&] { parse_ros_yaml(text, "y"); });
        EXPECT_NE(error.find(message), std::string::npos) << error << "\n" << text.substr(0, 80);
    }
}

}  // namespace
}  // namespace waybreaker::mapfile
