// A map with all metadata of its file, in any format.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "io/ros_yaml.hpp"
#include "site/annotations.hpp"
#include "site/georeference.hpp"
#include "site/overlay.hpp"
#include "waybreaker/map.hpp"
#include "waybreaker/mission.hpp"
#include "waybreaker/search_options.hpp"

namespace waybreaker::io {

// Metres that a cell can measure.
inline constexpr double least_cell_size = 1e-6;
inline constexpr double most_cell_size = 1e6;

// The area of cells of that side in metres; to a square millimetre, as sums of rounded numbers show digits that nobody
// measured.
inline double square_metres(std::uint64_t cells, double cell_size) {
    constexpr double square_millimetres = 1e6;
    const double area = double(cells) * (cell_size * cell_size);
    return area < 1 ? area : std::round(area * square_millimetres) / square_millimetres;
}

// What blocks in maps that are images.
struct ImageReading {
    // Cells are blocked from that on: darkness of a plain image (empty: 0.5), occupancy of a ROS map (empty: 1).
    std::optional<double> threshold = {};
    bool unknown_free = false;  // cells of unknown occupancy are free
    Nav2 nav2 = Nav2::jazzy;    // what makes a cell of a ROS map occupied, free or unknown
    friend bool operator==(const ImageReading&, const ImageReading&) = default;
};

// The mission that a map file holds beside its map: only the authors' XML does.
struct MapTask {
    std::optional<Cell> start = {};
    std::optional<Cell> goal = {};
    SearchOptions search = {};       // what the file leaves out has our defaults
    bool smoothing = false;          // it asks for paths to be smoothed, which nothing does
    std::vector<Agent> agents = {};  // of a task for many, in place of start and goal
    bool agents_turn = false;        // it says how they turn, which nothing heeds
};

struct MapFile {
    Map map;
    std::string source = {};       // file name without folders
    std::string format = {};       // for people: "MovingAI map", "ROS map", ...
    std::string digest = {};       // "sha256:..." of the file's bytes; a ROS map's YAML and image one after the other
    double cell_size = 1;          // metres per cell
    bool cell_size_given = false;  // by the user, not by the file
    double label_seconds = 0;
    std::optional<site::Georeference> georeference = {};
    // Without a georeference: the lower-left corner, in metres of the frame that a robot knows the map in.
    std::optional<std::array<double, 2>> origin = {};
    site::Annotations annotations = {};
    std::optional<MapTask> task = {};
    std::optional<RosFiles> ros = {};
    std::vector<site::OverlaySource> overlays = {};  // laid over it since it was read
    std::uint64_t unknown = 0;                       // cells of unknown occupancy
    std::vector<std::string> notes = {};  // of reading, for the user, a line each; the file's own are annotations

    // Whether lengths can be given in metres.
    bool has_metres() const { return cell_size_given || georeference || ros || cell_size != 1; }
    // Of so many cells. REQUIRES: has_metres().
    double square_metres(std::uint64_t cells) const { return io::square_metres(cells, cell_size); }
    // The file's own notes, and those of reading it.
    std::vector<std::string> all_notes() const {
        std::vector<std::string> all = annotations.notes;
        all.insert(all.end(), notes.begin(), notes.end());
        return all;
    }
    // What people call it: its title, or its file.
    const std::string& name() const { return annotations.title.empty() ? source : annotations.title; }
};

}  // namespace waybreaker::io
