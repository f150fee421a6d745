// What people call the obstacles of a label map. It stands in a metadata item of its GeoTIFF, WAYBREAKER_NAMES: a line
// for each obstacle that has a name, of its number in the cells, a blank and the name. Cells keep their numbers when
// gdal_translate cuts a piece out, so that names stay where they belong.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "waybreaker/map.hpp"

class GDALDataset;

namespace waybreaker::geo {

inline constexpr const char* names_item = "WAYBREAKER_NAMES";

// The text as one line of printable UTF-8, of at most 250 bytes.
std::string clean_name(std::string_view text);

// By obstacle id, entry 0 unused, empty where unknown. No entries at all if no obstacle has a name.
using ObstacleNames = std::vector<std::string>;

// How many obstacles have one.
std::size_t name_count(const ObstacleNames& names);

std::string names_text(const ObstacleNames& names);

// By the number in a label layer, before the map numbers its obstacles anew.
using LabelNames = std::unordered_map<std::uint32_t, std::string>;

// What a file says. Throws InputError if it cannot be understood; `name` is how the file is called in errors.
LabelNames read_names(GDALDataset& file, const std::string& name);

struct NamedCell {
    std::size_t cell;  // row by row
    std::string name;
};

// The first cell of each label that has a name.
std::vector<NamedCell> named_cells(LabelNames names, std::span<const std::uint32_t> labels);

// The names of the obstacles at these cells.
ObstacleNames obstacle_names(const Map& map, std::vector<NamedCell> cells);

}  // namespace waybreaker::geo
