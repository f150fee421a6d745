#include "labels/label_map.hpp"

#include <algorithm>
#include <utility>

#include "labels/kinds_item.hpp"
#include "labels/notes_item.hpp"
#include "labels/obstacle_metadata.hpp"
#include "labels/obstacle_names.hpp"
#include "labels/sections_item.hpp"
#include "labels/tags_item.hpp"

namespace waybreaker::labels {
namespace {

// Whether all labels other than 0 are equal.
bool has_one_value(const std::vector<std::uint32_t>& labels) {
    const auto first = std::find_if(labels.begin(), labels.end(), [](std::uint32_t l) { return l != 0; });
    return std::all_of(first, labels.end(), [&](std::uint32_t l) { return l == 0 || l == *first; });
}

Grid grid_of(int width, int height, const std::vector<std::uint32_t>& labels) {
    Grid grid(width, height);
    const std::uint32_t* label = labels.data();
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x, ++label) {
            if (*label != 0) grid.set_blocked({x, y}, true);
        }
    }
    return grid;
}

}  // namespace

LabelRaster read_items(const MetadataItems& items, int width, int height,
                       const std::optional<std::array<double, 6>>& transform, const Inflate& inflate,
                       const std::string& name) {
    LabelRaster raster{.layer = {.width = width,
                                 .height = height,
                                 .attributes = read_obstacle_metadata(items, name),
                                 .names = read_names(items(names_item), name),
                                 .kinds = read_kinds(items(kinds_item), name),
                                 .tags = read_tags(items(tags_item), name)},
                       .annotations = {.title = items(title_item),
                                       .profile = site::profile_called(items(profile_item)),
                                       .attribution = items(attribution_item),
                                       .notes = read_notes(items(notes_item))}};
    read_sections(items(sections_item), name, raster.layer);
    if (!transform) return raster;
    const auto cells_of = [&](const char* item) {
        return read_cells(items(item), item, *transform, width, height, inflate, name);
    };
    raster.annotations.bridges = cells_of(bridges_item);
    raster.annotations.ways = cells_of(ways_item);
    raster.annotations.unknown = cells_of(unknown_item);
    return raster;
}

LabelMap label_map(LabelRaster raster, Connectivity connectivity, const MapLimits& limits) {
    const int width = raster.layer.width;
    const int height = raster.layer.height;
    const std::vector<std::uint32_t>& labels = raster.layer.labels;
    const bool mask = raster.layer.attributes.size() == 1 && has_one_value(labels);
    if (limits.admit) {
        limits.admit(
            map_bytes(width, height,
                      mask ? count_obstacles(grid_of(width, height, labels), connectivity) : count_labels(labels)));
    }
    if (!mask) return {site::described(std::move(raster.layer), std::move(raster.annotations)), false};
    return {{Map(grid_of(width, height, labels), connectivity), std::move(raster.annotations)}, true};
}

}  // namespace waybreaker::labels
