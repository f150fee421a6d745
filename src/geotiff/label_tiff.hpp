// GeoTIFF label maps: obstacle id per cell, 0 = free, with coordinate system. The format `waybreaker import` writes.
//
// What GDAL's tools keep is kept in its own places: coordinate system and cell size, the title as TIFF image
// description, the attribution as TIFF copyright. What they have no place for, whom the map was made for
// (WAYBREAKER_PROFILE, a word of site/profile.hpp; one that this version does not know is passed over), who each
// obstacle is (labels/obstacle_metadata.hpp, obstacle_names.hpp, kinds_item.hpp, tags_item.hpp), of what it is a part
// (sections_item.hpp), what lies around them (background_item.hpp, bridges_item.hpp) and what was noticed of the ground
// (notes_item.hpp), stands in metadata items, which gdal_translate copies too: see docs/data.md.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "geotiff/georeference.hpp"
#include "map/map_size.hpp"
#include "site/annotations.hpp"
#include "waybreaker/map.hpp"

namespace waybreaker::geotiff {

struct LabelTiff {
    Map map;
    double cell_size = 1;  // metres per cell
    std::optional<site::Georeference> georeference = {};
    // Without a coordinate system: the lower-left corner, in metres of the frame that a robot knows the map in.
    std::optional<std::array<double, 2>> origin = {};
    site::Annotations annotations = {};
    bool mask = false;  // the file says which cells are blocked, but not by which obstacle
};

// The bytes of a GeoTIFF (or BigTIFF) file with one band of up to 32-bit integers, by whatever program. Where all that
// is not 0 has one value, and nothing says who the obstacles are, it is a mask: its obstacles are connected sets of
// cells. `name` is what errors call it. Throws InputError (name and remedy) on anything that is not such a map,
// or too large for the limits of grid.hpp.
LabelTiff read_label_tiff(std::string_view bytes, const std::string& name,
                          Connectivity connectivity = Connectivity::four, const MapLimits& limits = {});

// The bytes of such a file. Small: compressed, labels in the least type of 16 or 32 bits.
std::string label_tiff_bytes(const LabelTiff& tiff);

}  // namespace waybreaker::geotiff
