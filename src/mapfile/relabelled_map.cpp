#include "mapfile/relabelled_map.hpp"

#include <filesystem>
#include <string>
#include <utility>

#include "io/relabel.hpp"
#include "mapfile/grey_image.hpp"
#include "mapfile/occupancy.hpp"
#include "mapfile/ros_map.hpp"
#include "site/described_map.hpp"
#include "site/split.hpp"
#include "site/unknown_ground.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::mapfile {
namespace {

// By id, entry 0 unused.
std::vector<bool> removal_table(const Map& map, std::span<const ObstacleId> removed) {
    std::vector<bool> goes(map.obstacles().size() + 1);
    for (const ObstacleId id : removed) {
        const std::string what = "obstacle " + std::to_string(id.value);
        if (id.value == 0 || id.value >= goes.size()) {
            throw InputError("there is no " + what + ": the map has " + std::to_string(map.obstacles().size()) +
                             " obstacles");
        }
        if (!map.obstacle(id).destructible) throw InputError(what + " cannot be destroyed");
        goes[id.value] = true;
    }
    return goes;
}

// The files of a ROS map in which some cells are free now. Trinary maps stay trinary; others become raw ones, which
// hold every occupancy as it is.
io::RosFiles opened(const io::RosFiles& files, const std::string& name, const Map& map, const std::vector<bool>& goes) {
    const GreyImage image = read_image(files.image, name);
    const bool trinary = files.yaml.mode == io::RosMode::trinary;
    const std::uint8_t unknown = trinary ? 205 : 255;
    std::vector<std::uint8_t> grey;
    grey.reserve(image.pixels.size());
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const std::optional<int> percent =
            goes[map.labels()[i]] ? 0 : occupancy(image.pixels[i], image.transparency, files.yaml, files.nav2);
        const int known = trinary ? (percent == 0 ? 254 : 0) : percent.value_or(0);
        grey.push_back(percent ? std::uint8_t(known) : unknown);
    }
    io::RosFiles result{.yaml = {.image = std::filesystem::path(files.yaml.image).replace_extension(".pgm").string(),
                                 .mode = trinary ? io::RosMode::trinary : io::RosMode::raw,
                                 .resolution = files.yaml.resolution,
                                 .origin = files.yaml.origin},
                        .text = {},
                        .image = pgm_bytes(image.width, image.height, grey),
                        .nav2 = files.nav2};
    result.text = ros_yaml_text(result.yaml);
    return result;
}

void describe(io::MapFile& file, site::DescribedMap&& described) {
    file.map = std::move(described.map);
    file.annotations = std::move(described.annotations);
}

}  // namespace

io::MapFile without_obstacles(const io::MapFile& file, std::span<const ObstacleId> removed) {
    const std::vector<bool> goes = removal_table(file.map, removed);
    io::MapFile result = file;
    if (removed.empty()) return result;
    result.digest.clear();
    if (file.ros) result.ros = opened(*file.ros, file.source, file.map, goes);
    std::vector<std::uint32_t> labels(file.map.labels().begin(), file.map.labels().end());
    for (std::uint32_t& label : labels) {
        if (goes[label]) label = 0;
    }
    io::relabel(result, std::move(labels));
    return result;
}

io::MapFile in_sections(io::MapFile file, const site::Lattice& lattice) {
    if (!file.annotations.sections.empty()) {
        throw InputError(file.source + ": is cut into sections already; give the map that it was made from");
    }
    describe(file, site::split(file.map, file.annotations, lattice));
    file.digest.clear();
    file.ros.reset();  // its cells say nothing of sections
    return file;
}

io::MapFile with_overlay(io::MapFile file, const site::Overlay& overlay) {
    describe(file, site::laid_over(file.map, file.annotations, overlay));
    file.unknown = site::unknown_cells(file.map, file.annotations.tags);
    file.digest.clear();
    file.ros.reset();  // its image holds no such obstacles
    return file;
}

}  // namespace waybreaker::mapfile
