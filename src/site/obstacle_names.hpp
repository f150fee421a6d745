// Names of the obstacles of a map.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "waybreaker/map.hpp"

namespace waybreaker::site {

// By obstacle id, entry 0 unused, empty where unknown. No entries at all if no obstacle has a name.
using ObstacleNames = std::vector<std::string>;

// How many obstacles have one.
std::size_t name_count(const ObstacleNames& names);

// By the number in a label layer, before the map renumbers its obstacles.
using LabelNames = std::unordered_map<std::uint32_t, std::string>;

struct NamedCell {
    std::size_t cell;  // row by row
    std::string name;
};

// The first cell of each label that has a name.
std::vector<NamedCell> named_cells(LabelNames names, std::span<const std::uint32_t> labels);

// The names of the obstacles at these cells.
ObstacleNames obstacle_names(const Map& map, std::vector<NamedCell> cells);

}  // namespace waybreaker::site
