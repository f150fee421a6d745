// Any map file waybreaker reads, told apart by its content.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geo/label_tiff.hpp"
#include "io/authors_xml.hpp"
#include "io/ros_map.hpp"
#include "map/map_size.hpp"
#include "waybreaker/map.hpp"

namespace waybreaker::io {

// Metres that a cell can measure.
inline constexpr double least_cell_size = 1e-6;
inline constexpr double most_cell_size = 1e6;

// What blocks in maps that are images.
struct ImageReading {
    // Cells are blocked from that on: darkness of a plain image (empty: 0.5), occupancy of a ROS map (empty: 1).
    std::optional<double> threshold = {};
    bool unknown_free = false;  // cells of unknown occupancy are free
    friend bool operator==(const ImageReading&, const ImageReading&) = default;
};

// The files of a ROS map.
struct RosFiles {
    RosYaml yaml;
    std::string text;   // of the YAML
    std::string image;  // bytes
};

struct MapFile {
    Map map;
    std::string source = {};  // file name without folders
    std::string format = {};  // for people: "MovingAI map", "ROS map", ...
    std::string digest = {};  // "sha256:..." of the file's bytes; a ROS map's YAML and image one after the other
    double cell_size = 1;     // metres per cell
    double label_seconds = 0;
    std::optional<geo::Georeference> georeference = {};
    // Without a georeference: the lower-left corner, in metres of the frame that a robot knows the map in.
    std::optional<std::array<double, 2>> origin = {};
    std::string attribution = {};
    std::string title = {};
    geo::ObstacleNames names = {};     // what people call the obstacles
    geo::Background background = {};   // streets, water, ...
    std::optional<XmlTask> task = {};  // start, goal and options, where the file holds them
    std::optional<RosFiles> ros = {};
    std::uint64_t unknown = 0;            // cells of unknown occupancy
    std::vector<std::string> notes = {};  // what a person should know of the file, a line each

    // Empty where it is unknown.
    std::string_view name_of(ObstacleId id) const {
        return id.value < names.size() ? names[id.value] : std::string_view();
    }
};

// Throws InputError. A file that is no map is refused after its first bytes; "-" is standard input. `connectivity`
// applies to formats without a label layer.
MapFile read_map_file(const std::string& path, Connectivity connectivity = Connectivity::four,
                      const ImageReading& image = {});

// A map whose bytes are all there is of it: no other file is opened, so that a ROS map must be in one piece
// (ros_pieces). `name` is what errors call it. Throws SizeError for a map of too many cells, before it takes memory for
// them.
MapFile parse_map(std::string bytes, const std::string& name, Connectivity connectivity = Connectivity::four,
                  const ImageReading& image = {}, const MapLimits& limits = {});

}  // namespace waybreaker::io
