// A map with all metadata of its file, in any format.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/ros_yaml.hpp"
#include "site/background.hpp"
#include "site/georeference.hpp"
#include "site/obstacle_kinds.hpp"
#include "site/obstacle_names.hpp"
#include "waybreaker/map.hpp"
#include "waybreaker/search.hpp"

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

// The mission that a map file holds beside its map: only the authors' XML does.
struct MapTask {
    std::string title;
    double cell_size = 1;
    std::optional<Cell> start;
    std::optional<Cell> goal;
    SearchOptions search;  // what the file leaves out has our defaults
};

struct MapFile {
    Map map;
    std::string source = {};  // file name without folders
    std::string format = {};  // for people: "MovingAI map", "ROS map", ...
    std::string digest = {};  // "sha256:..." of the file's bytes; a ROS map's YAML and image one after the other
    double cell_size = 1;     // metres per cell
    double label_seconds = 0;
    std::optional<site::Georeference> georeference = {};
    // Without a georeference: the lower-left corner, in metres of the frame that a robot knows the map in.
    std::optional<std::array<double, 2>> origin = {};
    std::string attribution = {};
    std::string title = {};
    site::ObstacleNames names = {};    // what people call the obstacles
    site::Background background = {};  // streets, water, ...
    site::ObstacleKinds kinds = {};    // what the obstacles are: buildings, water, ...
    std::optional<MapTask> task = {};
    std::optional<RosFiles> ros = {};
    std::uint64_t unknown = 0;            // cells of unknown occupancy
    std::vector<std::string> notes = {};  // for the user, a line each

    // Empty where it is unknown.
    std::string_view name_of(ObstacleId id) const {
        return id.value < names.size() ? names[id.value] : std::string_view();
    }
};

}  // namespace waybreaker::io
