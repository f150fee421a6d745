// What a map file holds, in a few figures.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "io/map_file.hpp"

namespace waybreaker::mapfile {

struct MapSummary {
    std::uint64_t blocked = 0;          // cells
    double density = 0;                 // blocked cells, as a share of all
    const Obstacle* largest = nullptr;  // of several the first; null if there is no obstacle. The map must outlive it.
};

MapSummary summarise(const Map& map);

// How much of a map is what, in cells.
struct GroundSummary {
    std::uint64_t open = 0;
    std::uint64_t destructible = 0;
    std::uint64_t protected_ = 0;  // neither destructible nor one of the next
    std::uint64_t water = 0;
    std::uint64_t cliff = 0;
    std::uint64_t forbidden = 0;
    std::uint64_t off_road = 0;
    std::uint64_t unknown = 0;
};

// Empty if the file does not say what its obstacles are.
std::optional<GroundSummary> summarise_ground(const io::MapFile& file);

// By tag: how many obstacles have it that cannot be destroyed, though they are no ground of these kinds.
std::map<std::string, std::size_t> protected_tags(const io::MapFile& file);

// Longitude and latitude of the middle of the map. Precondition: it has a georeference.
std::array<double, 2> center(const io::MapFile& file);

// The coordinate system that the metres of the map's frame (io/map_frame.hpp) are coordinates of, such as "EPSG:32633";
// empty if they are of the map's own.
std::string frame_crs(const io::MapFile& file);

// What `waybreaker map info --json` writes: an indented object.
std::string map_info_json(const io::MapFile& file);

}  // namespace waybreaker::mapfile
