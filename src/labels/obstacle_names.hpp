// The names of a label map's obstacles as a metadata item of its GeoTIFF, WAYBREAKER_NAMES: a line for each obstacle
// that has a name, of its number in the cells, a blank and the name. Cells keep their numbers when gdal_translate cuts
// a piece out, so that names stay where they belong.
#pragma once

#include <string>
#include <string_view>

#include "site/obstacle_names.hpp"

namespace waybreaker::labels {

inline constexpr const char* names_item = "WAYBREAKER_NAMES";

// The text as one line of printable UTF-8, of at most 250 bytes.
std::string clean_name(std::string_view text);

std::string names_text(const site::ObstacleNames& names);

// What the item of a file says. Throws InputError if it cannot be understood; `name` is how the file is called in
// errors.
site::LabelNames read_names(std::string_view text, const std::string& name);

}  // namespace waybreaker::labels
