// What the maker of a label map noticed of its ground, as a metadata item of its GeoTIFF, WAYBREAKER_NOTES: a line
// each.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace waybreaker::labels {

inline constexpr const char* notes_item = "WAYBREAKER_NOTES";

// Empty if there are none.
std::string notes_text(const std::vector<std::string>& notes);

// What the item of a file says, as printable lines.
std::vector<std::string> read_notes(std::string_view text);

}  // namespace waybreaker::labels
