#include "city/sea.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "city/line_work.hpp"
#include "city/vector_source.hpp"
#include "geotiff/feature_parts.hpp"
#include "geotiff/gdal_scope.hpp"

namespace waybreaker::city {
namespace {

// Metres beside a coastline where one looks what lies there.
constexpr double step_aside = 0.01;

// Metres of it that may have one face on both sides.
constexpr double tolerance = 1;

std::vector<Line> pieces_within(const std::vector<const OGRGeometry*>& coasts, const OGREnvelope& bounds) {
    std::vector<Line> pieces;
    for (const OGRGeometry* coast : coasts) {
        const std::optional<geotiff::FeatureParts> parts = geotiff::parts_of(*coast);
        if (!parts) continue;
        for (const Line& line : parts->parts) {
            for (Line& piece : clipped(line, bounds)) pieces.push_back(std::move(piece));
        }
    }
    return pieces;
}

// At the edge of the data a way ends at its last point before it: up to so many metres short of the bounds, or such a
// share of their sides.
constexpr double cut_short = 200;
constexpr double cut_short_share = 0.15;

// From ends of coastlines near the bounds straight to them.
std::vector<Line> extensions(const std::vector<Line>& pieces, const OGREnvelope& bounds) {
    std::map<std::pair<double, double>, int> ends;
    for (const Line& piece : pieces) {
        for (const Point& end : {piece.front(), piece.back()}) ++ends[{end.x, end.y}];
    }
    const double reach =
        std::min(cut_short, cut_short_share * std::min(bounds.MaxX - bounds.MinX, bounds.MaxY - bounds.MinY));
    std::vector<Line> lines;
    for (const auto& [end, count] : ends) {
        const auto [x, y] = end;
        const std::array<Point, 4> feet{{{bounds.MinX, y}, {bounds.MaxX, y}, {x, bounds.MinY}, {x, bounds.MaxY}}};
        const Point from{x, y};
        const Point& foot = *std::min_element(feet.begin(), feet.end(), [&](const Point& a, const Point& b) {
            return distance(from, a) < distance(from, b);
        });
        const double gap = distance(from, foot);
        if (count == 1 && gap > 0 && gap <= reach) lines.push_back({from, foot});
    }
    return lines;
}

// The faces that the pieces cut the bounds into.
std::unique_ptr<OGRGeometry> faces_of(std::vector<Line> pieces, const OGREnvelope& bounds) {
    for (Line& line : extensions(pieces, bounds)) pieces.push_back(std::move(line));
    OGRMultiLineString cuts;
    for (const Line& piece : pieces) {
        OGRLineString line;
        for (const Point& point : piece) line.addPoint(point.x, point.y);
        cuts.addGeometry(&line);
    }
    OGRLineString edge;
    edge.addSubLineString(rectangle(bounds).getExteriorRing());
    const std::unique_ptr<OGRGeometry> noded(cuts.Union(&edge));
    return std::unique_ptr<OGRGeometry>(noded ? noded->Polygonize() : nullptr);
}

// How many metres of coastline have the face on their right, and on their left.
struct Sides {
    double right = 0;
    double left = 0;
};

Sides sides_of(const OGRGeometry& face, const std::vector<Line>& pieces) {
    OGREnvelope box;
    face.getEnvelope(&box);
    Sides sides;
    const OGRPreparedGeometryUniquePtr prepared(
        OGRCreatePreparedGeometry(OGRGeometry::ToHandle(const_cast<OGRGeometry*>(&face))));
    const auto holds = [&](double x, double y) {
        OGRPoint point(x, y);
        return x >= box.MinX && x <= box.MaxX && y >= box.MinY && y <= box.MaxY &&
               OGRPreparedGeometryContains(prepared.get(), OGRGeometry::ToHandle(&point));
    };
    for (const Line& piece : pieces) {
        for (std::size_t i = 1; i < piece.size(); ++i) {
            const Point& a = piece[i - 1];
            const Point& b = piece[i];
            const double length = distance(a, b);
            if (!(length > 0)) continue;
            const double x = (a.x + b.x) / 2;
            const double y = (a.y + b.y) / 2;
            const double east = (b.y - a.y) / length * step_aside;  // of the right-hand side
            const double north = (a.x - b.x) / length * step_aside;
            if (holds(x + east, y + north)) sides.right += length;
            if (holds(x - east, y - north)) sides.left += length;
        }
    }
    return sides;
}

}  // namespace

Sea sea_beside(const std::vector<const OGRGeometry*>& coasts, const OGREnvelope& bounds) {
    const geotiff::GdalScope gdal;
    Sea sea;
    const std::vector<Line> pieces = pieces_within(coasts, bounds);
    if (pieces.empty()) return sea;
    const std::unique_ptr<OGRGeometry> faces = faces_of(pieces, bounds);
    if (!faces) return sea;
    for (const OGRGeometry* face : *faces->toGeometryCollection()) {
        const Sides sides = sides_of(*face, pieces);
        if (sides.right > tolerance && sides.left > tolerance) sea.leaks = true;
        if (sides.right > sides.left) sea.areas.emplace_back(face->clone());
    }
    return sea;
}

}  // namespace waybreaker::city
