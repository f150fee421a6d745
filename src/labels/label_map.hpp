// A label map of its cells and metadata items, whoever has read them: GDAL, rasterio, a page. docs/data.md, "The file".
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "labels/cells_item.hpp"
#include "labels/metadata_items.hpp"
#include "map/map_size.hpp"
#include "site/described_map.hpp"

namespace waybreaker::labels {

inline constexpr const char* title_item = "TIFFTAG_IMAGEDESCRIPTION";
inline constexpr const char* attribution_item = "TIFFTAG_COPYRIGHT";
inline constexpr const char* profile_item = "WAYBREAKER_PROFILE";

struct LabelRaster {
    site::LabelLayer layer = {};
    site::Annotations annotations = {};
};

// What the items say, without the background, whose places must be projected; the layer still lacks its labels.
// `transform` is that of the map (site/georeference.hpp); a map without a coordinate system has none, and nothing is
// known of single cells. Throws InputError if an item cannot be understood; `name` is how the file is called in errors.
LabelRaster read_items(const MetadataItems& items, int width, int height,
                       const std::optional<std::array<double, 6>>& transform, const Inflate& inflate,
                       const std::string& name);

struct LabelMap {
    site::DescribedMap described;
    bool mask = false;  // the file says which cells are blocked, but not by which obstacle
};

// Where all that is not 0 has one value, and nothing says who the obstacles are, it is a mask: its obstacles are
// connected sets of cells. Throws as Map::from_labels, and what limits.admit throws.
LabelMap label_map(LabelRaster raster, Connectivity connectivity = Connectivity::four, const MapLimits& limits = {});

}  // namespace waybreaker::labels
