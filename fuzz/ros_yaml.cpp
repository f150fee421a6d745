#include "laws.hpp"
#include "mapfile/ros_map.hpp"

// Of some greys, in each way that an image can have them: what is unknown stays, and no obstacle has cells of both
// kinds.
static void judge_map(const waybreaker::io::RosYaml& yaml, waybreaker::io::Nav2 nav2) {
    using namespace waybreaker;
    mapfile::GreyImage image{6, 2, yaml.negate, {}};
    for (const int grey : {0, 50, 100, 150, 205, 255, 254, 205, 205, 100, 0, 0}) {
        image.pixels.push_back(mapfile::GreyImage::Pixel::of_grey(grey, grey == 150 ? 0 : 255));
    }
    const mapfile::RosCells cells = mapfile::ros_cells(image, yaml, 1, nav2);
    const Map map = mapfile::ros_map(cells, Connectivity::four, false);
    for (Cell c; c.y < image.height; ++c.y) {
        for (c.x = 0; c.x < image.width; ++c.x) {
            const bool unknown = cells.unknown.blocked(c);
            law(map.grid().blocked(c) == (unknown || cells.occupied.blocked(c)));
            law(!map.grid().blocked(c) || map.obstacle(map.obstacle_at(c)).destructible != unknown);
        }
    }
}

// What is read can be written and read again, and its image can be exchanged for another.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace waybreaker;
    read_or_refuse(data, size, [](std::string_view bytes) {
        const io::RosYaml yaml = mapfile::parse_ros_yaml(bytes, "input");
        law(yaml.resolution > 0 && yaml.free_thresh <= yaml.occupied_thresh);
        judge_map(yaml, io::Nav2::jazzy);
        judge_map(yaml, io::Nav2::humble);
        const io::RosYaml again = mapfile::parse_ros_yaml(mapfile::ros_yaml_text(yaml), "input");
        law(again.image == yaml.image && again.origin == yaml.origin && again.resolution == yaml.resolution);
        law(mapfile::parse_ros_yaml(mapfile::with_image(bytes, "other.pgm", "input"), "input").image == "other.pgm");
    });
    return 0;
}
