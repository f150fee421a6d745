// A map's background as a metadata item of its GeoTIFF, WAYBREAKER_BACKGROUND: a table (CSV) of its features in
// longitude and latitude, which GIS open, and which stays right when gdal_translate cuts a piece out or gdalwarp
// reprojects.
//
//     WKT;kind;class;name
//     MULTILINESTRING((13.38312 52.52131,13.38402 52.52144));street;primary;Friedrichstraße
//
// Neither GeoJSON nor quotes: GDAL takes ten bytes for each quote in a metadata item.
#pragma once

#include <string>
#include <string_view>

#include "geotiff/georeference.hpp"
#include "site/background.hpp"

namespace waybreaker::geotiff {

inline constexpr const char* background_item = "WAYBREAKER_BACKGROUND";

// Longer items are refused.
inline constexpr std::size_t max_background_bytes = std::size_t{1} << 23;

// Empty if there are no features. Quotes and semicolons of names become apostrophes and commas.
std::string background_text(const site::Background& background, const site::Georeference& place);

// Of a map of width x height cells: features that lie beside it are left out. Throws InputError if the text is no such
// table; `name` is how the file is called in errors.
site::Background parse_background(std::string_view text, const site::Georeference& place, int width, int height,
                                  const std::string& name);

}  // namespace waybreaker::geotiff
