#include "city/data_area.hpp"

#include <cstdint>
#include <vector>

#include "city/cell_runs.hpp"
#include "city/label_raster.hpp"
#include "map/label.hpp"
#include "site/unknown_ground.hpp"

namespace waybreaker::city {
namespace {

OGREnvelope box_around(const Footprints& footprints, const Survey& survey) {
    OGREnvelope all;
    const auto merge = [&all](const OGRGeometry& shape) {
        OGREnvelope box;
        shape.getEnvelope(&box);
        all.Merge(box);
    };
    for (const Footprint& footprint : footprints.list) merge(*footprint.shape);
    for (const Sight& sight : survey.scenery) merge(*sight.shape);
    for (const GroundPiece& piece : survey.ground.pieces) merge(*piece.shape);
    return all;
}

}  // namespace

std::unique_ptr<OGRGeometry> data_area(const Footprints& footprints, const Survey& survey) {
    if (footprints.data) return std::unique_ptr<OGRGeometry>(footprints.data->clone());
    const OGREnvelope box = footprints.extent.IsInit() ? footprints.extent : box_around(footprints, survey);
    return box.IsInit() ? std::make_unique<OGRPolygon>(rectangle(box)) : nullptr;
}

double share_of(const OGRGeometry* area, const OGREnvelope& bounds) {
    if (!area) return 0;
    return area_inside(*area, bounds) / ((bounds.MaxX - bounds.MinX) * (bounds.MaxY - bounds.MinY));
}

void append_unknown(const OGRGeometry* area, const CellWindow& window, site::LabelLayer& cells) {
    std::vector<std::uint32_t> known(cells.labels.size(), 0);
    if (area) paint({{area, 1}}, Cover::centre, window, known);
    Grid beyond(cells.width, cells.height);
    std::size_t i = 0;
    for (Cell c; c.y < cells.height; ++c.y) {
        for (c.x = 0; c.x < cells.width; ++c.x, ++i) {
            if (known[i] == 0 && cells.labels[i] == 0) beyond.set_blocked(c, true);
        }
    }
    const std::vector<std::uint32_t> components = label_components(beyond, Connectivity::four);
    const auto first = std::uint32_t(cells.attributes.size());
    for (i = 0; i < components.size(); ++i) {
        if (components[i] == 0) continue;
        const std::uint32_t label = first + components[i] - 1;
        cells.labels[i] = label;
        if (label < cells.attributes.size()) continue;
        cells.attributes.push_back({.destructible = false});
        cells.tags[site::unknown_tag].push_back(label);
    }
}

std::vector<site::CellRun> unknown_cells(const OGRGeometry* area, const std::vector<GroundPiece>& pieces,
                                         const CellWindow& window) {
    std::vector<std::uint32_t> unknown(std::size_t(window.width) * std::size_t(window.height), area ? 1 : 0);
    std::vector<Paint> paints;
    if (area) paints.push_back({area, 0});
    for (const GroundPiece& piece : pieces) paints.push_back({piece.shape.get(), 1});
    paint(paints, Cover::centre, window, unknown);
    return runs_of(unknown, window);
}

}  // namespace waybreaker::city
