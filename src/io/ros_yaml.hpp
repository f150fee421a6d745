// What the YAML of a ROS map says; how it is read and written: mapfile/ros_map.hpp.
#pragma once

#include <array>
#include <string>

namespace waybreaker::io {

enum class RosMode { trinary, scale, raw };

// The releases of nav2 that read maps alike. `jazzy`: Jazzy since May 2025, and all later ones; `humble`: those before.
enum class Nav2 { jazzy, humble };

struct RosYaml {
    std::string image = {};
    RosMode mode = RosMode::trinary;
    double resolution = 1;           // metres per cell
    std::array<double, 2> origin{};  // metres, of the lower-left corner of the lower-left cell
    bool negate = false;
    double occupied_thresh = 0.65;
    double free_thresh = 0.196;
};

// The files of a ROS map.
struct RosFiles {
    RosYaml yaml;
    std::string text;         // of the YAML
    std::string image;        // bytes
    Nav2 nav2 = Nav2::jazzy;  // how they were read
};

}  // namespace waybreaker::io
