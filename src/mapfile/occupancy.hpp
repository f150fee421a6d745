// What the pixels of a ROS map's image mean: nav2's map_io, in either of its versions (io::Nav2).
#pragma once

#include <optional>

#include "io/ros_yaml.hpp"
#include "mapfile/grey_image.hpp"

namespace waybreaker::mapfile {

// In percent, 0 (free) to 100 (occupied); empty for unknown. `transparency`: the image says how opaque its pixels are.
std::optional<int> occupancy(GreyImage::Pixel pixel, bool transparency, const io::RosYaml& yaml, io::Nav2 nav2);

}  // namespace waybreaker::mapfile
