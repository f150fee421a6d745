#include "city/ground_map.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "city/cell_runs.hpp"
#include "city/label_raster.hpp"
#include "city/vector_source.hpp"

namespace waybreaker::city {
namespace {

using Cells = std::vector<std::uint32_t>;

Cells no_cells(const CellWindow& window) {
    Cells cells(std::size_t(window.width) * std::size_t(window.height), 0);
    return cells;
}

// The pieces of a layer within the window; with their numbers, or a label for all.
void append(const std::vector<GroundPiece>& pieces, GroundLayer layer, const CellWindow& window,
            std::optional<std::uint32_t> label, std::vector<Paint>& paints) {
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const GroundPiece& piece = pieces[i];
        if (piece.use.layer != layer) continue;
        OGREnvelope box;
        piece.shape->getEnvelope(&box);
        if (window.window.bounds.Intersects(box)) paints.push_back({piece.shape.get(), label.value_or(i + 1)});
    }
}

// Columns, of each row from above its centre to below, that a disc comes over whose centre is that of a cell: from
// -reach to reach.
std::vector<int> disc_rows(double radius) {
    std::vector<int> reach;
    for (int row = 0; row - 0.5 < radius; ++row) {
        const double high = std::max(row - 0.5, 0.0);
        const double wide = std::sqrt(radius * radius - high * high);
        reach.push_back(int(std::ceil(wide + 0.5)) - 1);
    }
    return reach;
}

// Paints discs on all cells around those that lines touch: a disc that moves from one of these to the next stays on
// what is painted.
void paint_driven(const std::vector<Paint>& lines, std::uint32_t label, double radius, const CellWindow& window,
                  Cells& cells) {
    Cells touched = no_cells(window);
    paint(lines, Cover::touched, window, touched);
    const std::vector<int> reach = disc_rows(radius);
    const int rows = int(reach.size()) - 1;
    for (int y = 0; y < window.height; ++y) {
        for (int x = 0; x < window.width; ++x) {
            if (touched[std::size_t(y) * std::size_t(window.width) + std::size_t(x)] == 0) continue;
            for (int row = std::max(y - rows, 0); row <= std::min(y + rows, window.height - 1); ++row) {
                const int wide = reach[std::size_t(std::abs(row - y))];
                const auto begin = cells.begin() + std::ptrdiff_t(row) * window.width;
                std::fill(begin + std::max(x - wide, 0), begin + std::min(x + wide + 1, window.width), label);
            }
        }
    }
}

Cells ways(const std::vector<GroundPiece>& pieces, const CellWindow& window, double radius) {
    Cells opened = no_cells(window);
    const auto fill = [&](GroundLayer layer, GroundMap::Opens what) {
        std::vector<Paint> paints;
        append(pieces, layer, window, what, paints);
        paint(paints, Cover::centre, window, opened);
    };
    const auto drive = [&](GroundLayer layer, GroundMap::Opens what) {
        std::vector<Paint> paints;
        append(pieces, layer, window, what, paints);
        paint_driven(paints, what, radius, window, opened);
    };
    fill(GroundLayer::gate, GroundMap::barriers);
    drive(GroundLayer::underpass, GroundMap::forbidden_lines);
    drive(GroundLayer::way, GroundMap::everything);
    fill(GroundLayer::shut, GroundMap::nothing);
    return opened;
}

// Ways, as far as they are open, and what is as good as they.
Cells roads(const std::vector<GroundPiece>& pieces, const CellWindow& window, const Cells& opened) {
    Cells cells = no_cells(window);
    std::vector<Paint> paints;
    append(pieces, GroundLayer::road, window, 1, paints);
    paint(paints, Cover::centre, window, cells);
    for (std::size_t i = 0; i < cells.size(); ++i) {
        if (opened[i] == GroundMap::everything || opened[i] == GroundMap::forbidden_lines) cells[i] = 1;
    }
    return cells;
}

Cells bridges(const std::vector<GroundPiece>& pieces, const CellWindow& window) {
    Cells cells = no_cells(window);
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

// Whether a way passes what blocks otherwise.
bool is_open(const GroundUse& use, std::uint32_t opened) {
    const bool forbidden_line = use.layer == GroundLayer::forbidden && use.width > 0;
    const bool passed_below = forbidden_line || use.layer == GroundLayer::bridge_side;
    return opened == GroundMap::everything || (opened == GroundMap::forbidden_lines && passed_below);
}

}  // namespace

GroundMap ground_map(const std::vector<GroundPiece>& pieces, const CellWindow& window, Profile profile, double cell) {
    if (pieces.empty()) return {};
    GroundMap map{.blocked = {},
                  .opened = ways(pieces, window, site::body_radius(profile, cell)),
                  .ways = {},
                  .bridges = {},
                  .roads = {}};
    if (std::any_of(pieces.begin(), pieces.end(), [](const auto& piece) { return piece.use.bridge; })) {
        map.bridges = runs_of(bridges(pieces, window), window);
    }
    Cells driven = roads(pieces, window, map.opened);
    map.ways = runs_of(driven, window);
    if (keeps_to_roads(profile)) map.roads = std::move(driven);
    driven = {};  // before there are more cells
    map.blocked = no_cells(window);
    std::vector<Paint> paints;
    for (const GroundLayer layer : {GroundLayer::bridge_side, GroundLayer::water, GroundLayer::way_over,
                                    GroundLayer::forbidden, GroundLayer::closed}) {
        const bool opens = layer == GroundLayer::way_over;
        append(pieces, layer, window, opens ? std::optional<std::uint32_t>(0) : std::nullopt, paints);
    }
    paint(paints, Cover::centre, window, map.blocked);
    for (std::size_t i = 0; i < map.blocked.size(); ++i) {
        std::uint32_t& number = map.blocked[i];
        if (number != 0 && is_open(pieces[number - 1].use, map.opened[i])) number = 0;
    }
    return map;
}

}  // namespace waybreaker::city
