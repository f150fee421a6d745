// Maps of ROS (`map_server`, `nav2_map_server`): a YAML file that names an image and says what its pixels mean.
//
//     image: floor.pgm                # beside the YAML file
//     mode: trinary                   # or scale, raw
//     resolution: 0.05                # metres a cell
//     origin: [-10.0, -10.0, 0.0]     # of the lower-left corner of the lower-left cell; the yaw must turn nothing
//     negate: 0
//     occupied_thresh: 0.65
//     free_thresh: 0.196
//
// image, resolution and origin must be there; the rest has the values above. How a pixel becomes an occupancy is
// nav2's map_io (occupancy.hpp); which occupancy blocks is its costmap's: see docs/data.md.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "io/ros_yaml.hpp"
#include "mapfile/grey_image.hpp"
#include "waybreaker/map.hpp"

namespace waybreaker::mapfile {

// A text file with a line that begins with "image:", perhaps indented, or with braces around all of it and "image:" in
// them.
bool is_ros_yaml(std::string_view bytes);

// A ROS map in one piece, for uploads: the YAML, a line of three dots, which ends it, and the image's bytes.
struct RosPieces {
    std::string text;
    std::string image;
};
// Empty if the bytes are something else.
std::optional<RosPieces> ros_pieces(std::string_view bytes);

// Throws InputError with name and line.
io::RosYaml parse_ros_yaml(std::string_view bytes, const std::string& name);

struct RosCells {
    Grid occupied;
    Grid unknown;
    std::size_t unknown_count = 0;
    // Whether free_thresh makes the grey of 205 free that map savers write for unknown.
    bool frees_unknown = false;
    bool transparency = false;  // of the image
};

// Cells are occupied from an occupancy of `threshold` (a share, 1 in nav2's costmap) on.
RosCells ros_cells(const GreyImage& image, const io::RosYaml& yaml, double threshold, io::Nav2 nav2 = io::Nav2::jazzy);

// Obstacles are connected sets of occupied cells, and connected sets of unknown ones. The latter are not destructible,
// as it is unknown what is there, and are never merged with a wall that they touch.
Map ros_map(const RosCells& cells, Connectivity connectivity, bool unknown_free);

// The text of such a file, as nav2's map saver writes it; numbers come back the same.
std::string ros_yaml_text(const io::RosYaml& yaml);

// The text with another image name, otherwise unchanged.
std::string with_image(std::string_view bytes, const std::string& image, const std::string& name);

}  // namespace waybreaker::mapfile
