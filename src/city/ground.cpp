#include "city/ground.hpp"

#include <algorithm>
#include <utility>

#include "city/bridge_sides.hpp"
#include "city/places.hpp"
#include "city/posts.hpp"
#include "city/sea.hpp"
#include "city/vector_source.hpp"
#include "geotiff/gdal_scope.hpp"

namespace waybreaker::city {
namespace {

std::unique_ptr<OGRGeometry> strip(const OGRGeometry& line, double width) {
    return std::unique_ptr<OGRGeometry>(line.Buffer(width / 2, quarter_circle));
}

// The parts of a line outside of areas, without those shorter than `least` metres; null if there are none.
std::unique_ptr<OGRGeometry> outside(const OGRGeometry& line, const std::vector<const OGRGeometry*>& areas,
                                     double least) {
    std::unique_ptr<OGRGeometry> rest(line.clone());
    OGREnvelope box;
    rest->getEnvelope(&box);
    for (const OGRGeometry* area : areas) {
        OGREnvelope around;
        area->getEnvelope(&around);
        if (!around.Intersects(box)) continue;
        std::unique_ptr<OGRGeometry> less(rest->Difference(area));
        if (less) rest = std::move(less);
    }
    auto pieces = std::make_unique<OGRMultiLineString>();
    const std::unique_ptr<OGRGeometry> all(OGRGeometryFactory::forceToMultiLineString(rest.release()));
    if (wkbFlatten(all->getGeometryType()) != wkbMultiLineString) return nullptr;
    for (const OGRLineString* piece : *all->toMultiLineString()) {
        if (piece->get_Length() >= least) pieces->addGeometry(piece);
    }
    return pieces->IsEmpty() ? nullptr : std::move(pieces);
}

template <typename Holds>
std::vector<const OGRGeometry*> areas_that(const std::vector<GroundPiece>& pieces, Holds holds) {
    std::vector<const OGRGeometry*> areas;
    for (const GroundPiece& piece : pieces) {
        if (is_area(piece.shape->getGeometryType()) && holds(piece.use)) areas.push_back(piece.shape.get());
    }
    return areas;
}

void append_sea(Ground& ground, std::vector<GroundPiece> coasts, const OGREnvelope& bounds, double cell) {
    std::vector<const OGRGeometry*> lines;
    for (const GroundPiece& coast : coasts) lines.push_back(coast.shape.get());
    Sea sea = sea_beside(lines, rectangle(bounds));
    const GroundUse use{GroundLayer::water, site::ObstacleKind::water};
    for (std::unique_ptr<OGRGeometry>& area : sea.areas) ground.pieces.push_back({use, std::move(area)});
    if (!sea.leaks) return;
    ground.notes.emplace_back(
        "a coastline ends within the window: parts of the sea may count as land, or of the land as sea");
    for (GroundPiece& coast : coasts) {
        coast.use = use;
        coast.use.width = cell;
        ground.pieces.push_back(std::move(coast));
    }
}

}  // namespace

bool bars(const GroundUse& use) {
    return use.layer == GroundLayer::water || use.layer == GroundLayer::forbidden || use.layer == GroundLayer::closed;
}

Ground finished(Ground ground, std::vector<GroundPiece> coasts, const OGREnvelope& bounds, double cell) {
    const geotiff::GdalScope gdal;
    append_sea(ground, std::move(coasts), bounds, cell);
    widen_posts(ground.pieces, cell);
    widen_bridge_sides(ground.pieces, cell);
    const auto waters =
        areas_that(ground.pieces, [](const GroundUse& use) { return use.kind == site::ObstacleKind::water; });
    const auto closed =
        areas_that(ground.pieces, [](const GroundUse& use) { return use.layer == GroundLayer::closed; });
    for (GroundPiece& piece : ground.pieces) {
        const GroundUse& use = piece.use;
        const bool way = use.layer == GroundLayer::way || use.layer == GroundLayer::underpass;
        const bool line = is_line(piece.shape->getGeometryType());
        if (use.layer == GroundLayer::road && line && use.width <= cell) {
            piece.shape.reset();  // its way opens every cell whose centre is that near
            continue;
        }
        if (use.outline && !line) piece.shape.reset(piece.shape->Boundary());
        if (use.drawn_as_area) piece.shape = outside(*piece.shape, waters, use.width);
        if (way && !closed.empty()) piece.shape = outside(*piece.shape, closed, 0);
        if (!piece.shape) continue;
        if (way) continue;  // opens cells by its line
        if (use.layer == GroundLayer::gate) {
            // Across a barrier of one cell, wherever the cells lie.
            piece.shape = strip(*piece.shape, 2 * std::max(opened_reach(use.width, cell), cell));
        } else if (line || use.outline) {
            piece.shape = strip(*piece.shape, std::max(use.width, cell));
        }
    }
    std::erase_if(ground.pieces, [](const GroundPiece& piece) { return !piece.shape || piece.shape->IsEmpty(); });
    return ground;
}

}  // namespace waybreaker::city
