#include "city/ground_map.hpp"

#include <algorithm>
#include <optional>

#include "city/label_raster.hpp"
#include "city/vector_source.hpp"

namespace waybreaker::city {
namespace {

// The pieces of a layer within the window; with their numbers, or a label for all.
void append(const std::vector<GroundPiece>& pieces, GroundLayer layer, const CellWindow& window, bool lines,
            std::optional<std::uint32_t> label, std::vector<Paint>& paints) {
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const GroundPiece& piece = pieces[i];
        if (piece.use.layer != layer || is_line(piece.shape->getGeometryType()) != lines) continue;
        OGREnvelope box;
        piece.shape->getEnvelope(&box);
        if (window.window.bounds.Intersects(box)) paints.push_back({piece.shape.get(), label.value_or(i + 1)});
    }
}

std::vector<std::uint32_t> ways(const std::vector<GroundPiece>& pieces, const CellWindow& window) {
    std::vector<std::uint32_t> opened(std::size_t(window.width) * std::size_t(window.height), GroundMap::nothing);
    const auto open = [&](GroundLayer layer, GroundMap::Opens what) {
        for (const bool lines : {false, true}) {
            std::vector<Paint> paints;
            append(pieces, layer, window, lines, what, paints);
            paint(paints, lines ? Cover::touched : Cover::centre, window, opened);
        }
    };
    open(GroundLayer::gate, GroundMap::barriers);
    open(GroundLayer::underpass, GroundMap::forbidden_lines);
    open(GroundLayer::way, GroundMap::everything);
    return opened;
}

std::vector<std::uint32_t> bridges(const std::vector<GroundPiece>& pieces, const CellWindow& window) {
    if (std::none_of(pieces.begin(), pieces.end(), [](const auto& piece) { return piece.use.bridge; })) return {};
    std::vector<std::uint32_t> cells(std::size_t(window.width) * std::size_t(window.height), 0);
    for (const bool lines : {false, true}) {
        std::vector<Paint> paints;
        for (const GroundPiece& piece : pieces) {
            if (piece.use.bridge && is_line(piece.shape->getGeometryType()) == lines) {
                paints.push_back({piece.shape.get(), 1});
            }
        }
        paint(paints, lines ? Cover::touched : Cover::centre, window, cells);
    }
    return cells;
}

}  // namespace

GroundMap ground_map(const std::vector<GroundPiece>& pieces, const CellWindow& window) {
    if (pieces.empty()) return {};
    GroundMap map{.blocked = std::vector<std::uint32_t>(std::size_t(window.width) * std::size_t(window.height), 0),
                  .opened = ways(pieces, window),
                  .bridges = bridges(pieces, window)};
    std::vector<Paint> paints;
    for (const GroundLayer layer :
         {GroundLayer::water, GroundLayer::way_over, GroundLayer::forbidden, GroundLayer::closed}) {
        const bool opens = layer == GroundLayer::way_over;
        append(pieces, layer, window, false, opens ? std::optional<std::uint32_t>(0) : std::nullopt, paints);
    }
    paint(paints, Cover::centre, window, map.blocked);
    for (std::size_t i = 0; i < map.blocked.size(); ++i) {
        std::uint32_t& number = map.blocked[i];
        if (number == 0) continue;
        const GroundUse& use = pieces[number - 1].use;
        const bool forbidden_line = use.layer == GroundLayer::forbidden && use.width > 0;
        if (map.opened[i] == GroundMap::everything || (map.opened[i] == GroundMap::forbidden_lines && forbidden_line)) {
            number = 0;
        }
    }
    return map;
}

}  // namespace waybreaker::city
