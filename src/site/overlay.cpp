#include "site/overlay.hpp"

#include <algorithm>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "waybreaker/error.hpp"

namespace waybreaker::site {
namespace {

bool can_be_destroyed(OverlayUse use) {
    return use == OverlayUse::debris || use == OverlayUse::wall;
}

ObstacleKind kind_of(OverlayUse use) {
    if (use == OverlayUse::water) return ObstacleKind::water;
    return use == OverlayUse::closed ? ObstacleKind::forbidden : ObstacleKind::barrier;
}

// By cell.
std::vector<bool> mask_of(const std::vector<CellRun>& runs, const Map& map) {
    std::vector<bool> mask(map.labels().size(), false);
    for (const auto& [first, length] : runs) {
        for (int x = 0; x < length; ++x) {
            const Cell cell{first.x + x, first.y};
            if (map.grid().contains(cell)) {
                mask[std::size_t(cell.y) * std::size_t(map.width()) + std::size_t(cell.x)] = true;
            }
        }
    }
    return mask;
}

// Makes labels of the things; gives the number of the one before the first.
std::uint32_t append(const Overlay& overlay, LabelLayer& layer) {
    const auto before = std::uint32_t(layer.attributes.size() - 1);
    const LabelLayer& things = overlay.things;
    for (std::uint32_t thing = 1; thing < things.attributes.size(); ++thing) {
        const std::uint32_t label = before + thing;
        ObstacleAttributes attributes = things.attributes[thing];
        attributes.destructible = can_be_destroyed(overlay.use);
        layer.attributes.push_back(attributes);
        layer.kinds.emplace(label, kind_of(overlay.use));
        if (const auto name = things.names.find(thing); name != things.names.end()) {
            layer.names.emplace(label, name->second);
        }
        if (attributes.destructible) {
            layer.tags["barrier=" + std::string(overlay_use_words[std::size_t(overlay.use)])].push_back(label);
        }
    }
    return before;
}

}  // namespace

DescribedMap laid_over(const Map& map, Annotations annotations, const Overlay& overlay) {
    const LabelLayer& things = overlay.things;
    if (things.width != map.width() || things.height != map.height()) {
        throw InputError("an overlay has as many cells as its map");
    }
    LabelLayer layer = label_layer(map, annotations);
    const std::vector<bool> bridges = mask_of(annotations.bridges, map);
    const std::uint32_t before = overlay.use == OverlayUse::free ? 0 : append(overlay, layer);
    bool changed = false;
    for (std::size_t i = 0; i < layer.labels.size(); ++i) {
        std::uint32_t& label = layer.labels[i];
        if (things.labels[i] == 0) continue;
        const bool bars_for_ever = label != 0 && !layer.attributes[label].destructible;
        const std::uint32_t former = label;
        switch (overlay.use) {
            case OverlayUse::free:
                label = 0;
                break;
            case OverlayUse::debris:
            case OverlayUse::wall:
                if (label == 0) label = before + things.labels[i];
                break;
            case OverlayUse::water:
                if (!bars_for_ever && !bridges[i]) label = before + things.labels[i];
                break;
            case OverlayUse::closed:
                if (!bars_for_ever) label = before + things.labels[i];
                break;
        }
        changed = changed || label != former;
    }
    if (changed && !annotations.title.empty()) {
        annotations.title += ", " + overlay.name + " as " + std::string(overlay_use_words[std::size_t(overlay.use)]);
    }
    return described(std::move(layer), std::move(annotations));
}

std::string doubt(const Annotations& annotations, const Overlay& overlay) {
    const std::vector<std::uint32_t>& labels = overlay.things.labels;
    const bool flood = overlay.use == OverlayUse::water && std::ranges::any_of(labels, std::identity());
    if (!flood || !annotations.bridges.empty()) return "";
    return "the map knows no bridges: every way in the water is closed; lay those that lead over it on top as free";
}

}  // namespace waybreaker::site
