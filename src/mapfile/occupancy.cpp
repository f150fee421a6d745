#include "mapfile/occupancy.hpp"

#include <cmath>

namespace waybreaker::mapfile {
namespace {

constexpr int fully_occupied = 100;
constexpr int most_sample = 255;

std::optional<int> of_raw(int value) {
    return value <= fully_occupied ? std::optional(value) : std::nullopt;
}

// nav2 PR 5071 (April 2025). It computes with floats, and so do the comparisons here.
std::optional<int> in_jazzy(GreyImage::Pixel pixel, const io::RosYaml& yaml) {
    if (yaml.mode == io::RosMode::raw) return of_raw(pixel.luma);
    if (pixel.alpha < most_sample) return std::nullopt;
    const float light = float(pixel.luma) / float(most_sample);
    const float share = yaml.negate ? light : 1.0F - light;
    const auto occupied_thresh = float(yaml.occupied_thresh);
    const auto free_thresh = float(yaml.free_thresh);
    if (share <= free_thresh) return 0;
    if (share >= occupied_thresh) return fully_occupied;
    if (yaml.mode == io::RosMode::trinary) return std::nullopt;
    return int(
        std::round((share - free_thresh) / float(yaml.occupied_thresh - yaml.free_thresh) * float(fully_occupied)));
}

std::optional<int> in_humble(GreyImage::Pixel pixel, bool transparency, const io::RosYaml& yaml) {
    if (yaml.mode == io::RosMode::raw) return of_raw(int(std::round(pixel.sum / 3.0)));
    // Of whole numbers, so that a quotient that should equal a threshold does. In trinary mode nav2 took how opaque a
    // pixel is for a fourth colour.
    const bool four = yaml.mode == io::RosMode::trinary && transparency;
    const int most = (four ? 4 : 3) * most_sample;
    const int light = pixel.sum + (four ? pixel.alpha : 0);
    const double share = double(yaml.negate ? light : most - light) / most;
    if (yaml.mode == io::RosMode::scale && pixel.alpha < most_sample) return std::nullopt;
    if (share > yaml.occupied_thresh) return fully_occupied;
    if (share < yaml.free_thresh) return 0;
    if (yaml.mode == io::RosMode::trinary) return std::nullopt;
    const double width = yaml.occupied_thresh - yaml.free_thresh;
    return width > 0 ? int(std::rint((share - yaml.free_thresh) / width * fully_occupied)) : fully_occupied;
}

}  // namespace

std::optional<int> occupancy(GreyImage::Pixel pixel, bool transparency, const io::RosYaml& yaml, io::Nav2 nav2) {
    return nav2 == io::Nav2::humble ? in_humble(pixel, transparency, yaml) : in_jazzy(pixel, yaml);
}

}  // namespace waybreaker::mapfile
