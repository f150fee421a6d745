// Scenery as a map shows it.
#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <tuple>
#include <utility>

#include "city/line_work.hpp"
#include "city/scenery.hpp"
#include "city/vector_source.hpp"
#include "geotiff/background_item.hpp"
#include "geotiff/feature_parts.hpp"
#include "geotiff/gdal_scope.hpp"

namespace waybreaker::city {
namespace {

using FeatureKind = site::Background::Kind;
using Shape = site::Background::Shape;
using Parts = std::vector<std::vector<Point>>;

constexpr double least_length = 2;  // of a line worth a place, in cells
constexpr double least_area = 16;   // of a ring
constexpr int least_rank = 3;

// Half of what a reader accepts: the file may need more bytes for its points than estimated here.
constexpr std::size_t most_bytes = geotiff::max_background_bytes / 2;

struct Extent {
    OGREnvelope bounds;
    double cell;

    Point to_cells(Point p) const { return {(p.x - bounds.MinX) / cell - 0.5, (bounds.MaxY - p.y) / cell - 0.5}; }
};

Line simplified(const Line& line, double tolerance) {
    OGRLineString exact;
    for (const Point& point : line) exact.addPoint(point.x, point.y);
    const std::unique_ptr<OGRGeometry> simple(exact.Simplify(tolerance));
    const std::optional<geotiff::FeatureParts> parts = simple ? geotiff::parts_of(*simple) : std::nullopt;
    return parts && parts->parts.size() == 1 ? parts->parts.front() : line;
}

Parts lines_of(const std::vector<const Sight*>& sights, const Extent& extent) {
    std::vector<Line> ways;
    for (const Sight* sight : sights) {
        if (std::optional<geotiff::FeatureParts> parts = geotiff::parts_of(*sight->shape)) {
            std::move(parts->parts.begin(), parts->parts.end(), std::back_inserter(ways));
        }
    }
    Parts lines;
    for (const Line& way : joined(std::move(ways))) {
        for (const Line& piece : clipped(way, extent.bounds)) {
            if (length_of(piece) >= least_length * extent.cell) lines.push_back(simplified(piece, extent.cell / 2));
        }
    }
    return lines;
}

// All polygons of a geometry, wherever in it they are.
void collect_polygons(const OGRGeometry& shape, OGRMultiPolygon& polygons) {
    if (wkbFlatten(shape.getGeometryType()) == wkbPolygon) {
        polygons.addGeometry(&shape);
    } else if (OGR_GT_IsSubClassOf(shape.getGeometryType(), wkbGeometryCollection)) {
        for (const OGRGeometry* part : *shape.toGeometryCollection()) collect_polygons(*part, polygons);
    }
}

// The polygons of a shape within bounds.
OGRMultiPolygon polygons_within(const OGRGeometry& shape, const OGREnvelope& bounds) {
    OGRMultiPolygon polygons;
    const OGRPolygon window = rectangle(bounds);
    const std::unique_ptr<OGRGeometry> valid(shape.MakeValid());
    const std::unique_ptr<OGRGeometry> part(valid ? valid->Intersection(&window) : nullptr);
    if (part) collect_polygons(*part, polygons);
    return polygons;
}

// Areas of one name are one, for rings would make holes where they overlap.
Parts areas_of(const std::vector<const Sight*>& sights, const Extent& extent) {
    OGRMultiPolygon all;
    for (const Sight* sight : sights) collect_polygons(polygons_within(*sight->shape, extent.bounds), all);
    if (all.IsEmpty()) return {};
    const std::unique_ptr<OGRGeometry> united(all.UnionCascaded());
    const std::unique_ptr<OGRGeometry> simple(united ? united->SimplifyPreserveTopology(extent.cell) : nullptr);
    std::optional<geotiff::FeatureParts> parts = simple ? geotiff::parts_of(*simple) : std::nullopt;
    if (!parts) return {};
    std::erase_if(parts->parts, [&](const auto& ring) {
        return std::abs(geotiff::signed_area(ring)) < least_area * extent.cell * extent.cell;
    });
    return std::move(parts->parts);
}

// Where the name of a place goes, in the middle of what can be seen of it: once, however often the source says it.
Parts place_of(const std::vector<const Sight*>& sights, const Extent& extent) {
    for (const Sight* sight : sights) {
        const bool area = is_area(sight->shape->getGeometryType());
        const OGRMultiPolygon seen = area ? polygons_within(*sight->shape, extent.bounds) : OGRMultiPolygon();
        OGRPoint middle;
        const OGRGeometry& shape = area ? static_cast<const OGRGeometry&>(seen) : *sight->shape;
        if (shape.IsEmpty() || shape.Centroid(&middle) != OGRERR_NONE || middle.IsEmpty()) continue;
        return {{{middle.getX(), middle.getY()}}};
    }
    return {};
}

Shape drawn_shape(const Sight& sight) {
    if (sight.kind == FeatureKind::place) return Shape::point;
    return is_area(sight.shape->getGeometryType()) ? Shape::area : Shape::line;
}

// About what it takes in the file.
std::size_t bytes_of(const site::Background::Feature& feature) {
    constexpr std::size_t of_feature = 50;
    constexpr std::size_t of_point = 21;
    std::size_t bytes = of_feature + feature.type.size() + feature.name.size();
    for (const auto& part : feature.parts) bytes += of_point * (part.size() + 1);
    return bytes;
}

}  // namespace

site::Background background_within(const std::vector<Sight>& scenery, const OGREnvelope& bounds, double cell) {
    const geotiff::GdalScope gdal;
    const Extent extent{bounds, cell};
    // Sights of one name and class are one feature.
    std::map<std::tuple<FeatureKind, int, std::string, Shape, std::string>, std::vector<const Sight*>> groups;
    for (const Sight& sight : scenery) {
        OGREnvelope box;
        sight.shape->getEnvelope(&box);
        if (!bounds.Intersects(box)) continue;
        groups[{sight.kind, sight.rank, sight.type, drawn_shape(sight), sight.name}].push_back(&sight);
    }
    std::vector<std::pair<int, site::Background::Feature>> ranked;
    std::size_t bytes = 0;
    for (const auto& [key, sights] : groups) {
        const auto& [kind, rank, type, shape, name] = key;
        Parts parts = shape == Shape::line   ? lines_of(sights, extent)
                      : shape == Shape::area ? areas_of(sights, extent)
                                             : place_of(sights, extent);
        for (auto& part : parts) {
            for (Point& point : part) point = extent.to_cells(point);
        }
        if (parts.empty()) continue;
        ranked.emplace_back(rank, site::Background::Feature{kind, type, name, shape, std::move(parts)});
        bytes += bytes_of(ranked.back().second);
    }
    for (int rank = least_rank; bytes > most_bytes && rank >= 0; --rank) {
        std::erase_if(ranked, [&](const auto& feature) {
            if (feature.first == rank) bytes -= bytes_of(feature.second);
            return feature.first == rank;
        });
    }
    site::Background background;
    for (auto& feature : ranked) background.features.push_back(std::move(feature.second));
    return background;
}

}  // namespace waybreaker::city
