#include "geo/ground.hpp"

#include <algorithm>
#include <utility>

#include "geo/gdal_scope.hpp"
#include "geo/sea.hpp"
#include "geo/vector_source.hpp"

namespace waybreaker::geo {
namespace {

constexpr int quarter_circle = 4;  // corners

std::unique_ptr<OGRGeometry> strip(const OGRGeometry& line, double width) {
    return std::unique_ptr<OGRGeometry>(line.Buffer(width / 2, quarter_circle));
}

bool is_water_area(const GroundPiece& piece) {
    return piece.use.kind == site::ObstacleKind::water && is_area(piece.shape->getGeometryType());
}

// What areas of water leave of a river's line, without slivers shorter than the river is wide; null if nothing.
std::unique_ptr<OGRGeometry> outside_water(const OGRGeometry& line, double width,
                                           const std::vector<const OGRGeometry*>& waters) {
    std::unique_ptr<OGRGeometry> rest(line.clone());
    OGREnvelope box;
    rest->getEnvelope(&box);
    for (const OGRGeometry* water : waters) {
        OGREnvelope around;
        water->getEnvelope(&around);
        if (!around.Intersects(box)) continue;
        std::unique_ptr<OGRGeometry> less(rest->Difference(water));
        if (less) rest = std::move(less);
    }
    auto pieces = std::make_unique<OGRMultiLineString>();
    const std::unique_ptr<OGRGeometry> all(OGRGeometryFactory::forceToMultiLineString(rest.release()));
    if (wkbFlatten(all->getGeometryType()) != wkbMultiLineString) return nullptr;
    for (const OGRLineString* piece : *all->toMultiLineString()) {
        if (piece->get_Length() >= width) pieces->addGeometry(piece);
    }
    return pieces->IsEmpty() ? nullptr : std::move(pieces);
}

void append_sea(Ground& ground, std::vector<GroundPiece> coasts, const OGREnvelope& bounds, double cell) {
    std::vector<const OGRGeometry*> lines;
    for (const GroundPiece& coast : coasts) lines.push_back(coast.shape.get());
    Sea sea = sea_beside(lines, bounds);
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

Ground finished(Ground ground, std::vector<GroundPiece> coasts, const OGREnvelope& bounds, double cell) {
    const GdalScope gdal;
    append_sea(ground, std::move(coasts), bounds, cell);
    std::vector<const OGRGeometry*> waters;
    for (const GroundPiece& piece : ground.pieces) {
        if (is_water_area(piece)) waters.push_back(piece.shape.get());
    }
    std::vector<GroundPiece> strips;
    for (GroundPiece& piece : ground.pieces) {
        GroundUse& use = piece.use;
        const bool way = use.layer == GroundLayer::way || use.layer == GroundLayer::underpass;
        const bool line = is_line(piece.shape->getGeometryType());
        if (use.outline && !line) piece.shape.reset(piece.shape->Boundary());
        if (use.drawn_as_area) piece.shape = outside_water(*piece.shape, use.width, waters);
        if (!piece.shape) continue;
        if (way) {  // opens the cells that its line touches
            if (use.width > cell) strips.push_back({use, strip(*piece.shape, use.width)});
        } else if (use.layer == GroundLayer::gate) {
            // Across a barrier of one cell, wherever the cells lie.
            piece.shape = strip(*piece.shape, std::max(use.width, 2 * cell));
        } else if (line || use.outline) {
            piece.shape = strip(*piece.shape, std::max(use.width, cell));
        }
    }
    std::move(strips.begin(), strips.end(), std::back_inserter(ground.pieces));
    std::erase_if(ground.pieces, [](const GroundPiece& piece) { return !piece.shape || piece.shape->IsEmpty(); });
    return ground;
}

}  // namespace waybreaker::geo
