// Of what the sections of a label map are parts, as a metadata item of its GeoTIFF, WAYBREAKER_SECTIONS: a line for
// each structure that was cut, of its kind, its source id and the numbers of its sections in the cells, with blanks
// between, and its name after a tab, if it has one. Cells keep their numbers when gdal_translate cuts a piece out.
//
//     building 4711 1 2 5<tab>Town hall
//     barrier 4712 2
#pragma once

#include <string>
#include <string_view>

#include "site/described_map.hpp"

namespace waybreaker::labels {

inline constexpr const char* sections_item = "WAYBREAKER_SECTIONS";

// Empty if there are none.
std::string sections_text(const site::Sections& sections);

// Reads what the item of a file says into the structures and parts of a layer. Kinds that this version does not know
// count as unknown. Throws InputError if it cannot be understood; `name` is how the file is called in errors.
void read_sections(std::string_view text, const std::string& name, site::LabelLayer& layer);

}  // namespace waybreaker::labels
