// The tags of a label map's obstacles as a metadata item of its GeoTIFF, WAYBREAKER_TAGS: a line for each tag, of its
// key=value, a tab, and the numbers in the cells of the obstacles that have it, with blanks between. Cells keep their
// numbers when gdal_translate cuts a piece out.
//
//     amenity=school<tab>1 7 12
#pragma once

#include <string>
#include <string_view>

#include "site/obstacle_tags.hpp"

namespace waybreaker::labels {

inline constexpr const char* tags_item = "WAYBREAKER_TAGS";

// Empty if nothing is known.
std::string tags_text(const site::ObstacleTags& tags);

// What the item of a file says. Throws InputError if it cannot be understood; `name` is how the file is called in
// errors.
site::LabelTags read_tags(std::string_view text, const std::string& name);

}  // namespace waybreaker::labels
