// What the obstacles of a label map are, as a metadata item of its GeoTIFF, WAYBREAKER_KINDS: a line for each kind, of
// its word and the numbers of its obstacles in the cells, with blanks between. Cells keep their numbers when
// gdal_translate cuts a piece out. Of obstacles that no line names nothing is known.
//
//     building 1 2 5
//     water 3 4
#pragma once

#include <string>
#include <string_view>

#include "site/obstacle_kinds.hpp"

namespace waybreaker::labels {

inline constexpr const char* kinds_item = "WAYBREAKER_KINDS";

// Empty if nothing is known.
std::string kinds_text(const site::ObstacleKinds& kinds);

// What the item of a file says. Kinds that this version does not know count as unknown. Throws InputError if it cannot
// be understood; `name` is how the file is called in errors.
site::LabelKinds read_kinds(std::string_view text, const std::string& name);

}  // namespace waybreaker::labels
