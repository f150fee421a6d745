#include "io/ros_map.hpp"
#include "laws.hpp"

// What is read can be written and read again, and its image can be exchanged for another.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace waybreaker;
    read_or_refuse(data, size, [](std::string_view bytes) {
        const io::RosYaml yaml = io::parse_ros_yaml(bytes, "input");
        law(yaml.resolution > 0 && yaml.free_thresh <= yaml.occupied_thresh);
        const io::RosYaml again = io::parse_ros_yaml(io::ros_yaml_text(yaml), "input");
        law(again.image == yaml.image && again.origin == yaml.origin && again.resolution == yaml.resolution);
        law(io::parse_ros_yaml(io::with_image(bytes, "other.pgm", "input"), "input").image == "other.pgm");
    });
    return 0;
}
