// What a map file holds, in a few figures.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "io/map_file.hpp"

namespace waybreaker::io {

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
std::optional<GroundSummary> summarise_ground(const MapFile& file);

// By tag: how many obstacles have it that cannot be destroyed, though they are no ground of these kinds.
std::map<std::string, std::size_t> protected_tags(const MapFile& file);

// The members of `waybreaker map info --json`. `georeference` is that member, which only projections know.
nlohmann::ordered_json map_info(const MapFile& file, const nlohmann::ordered_json& georeference);

}  // namespace waybreaker::io
