#include "city/sea.hpp"

#include <optional>
#include <utility>

#include "city/edge_faces.hpp"
#include "geotiff/feature_parts.hpp"
#include "geotiff/gdal_scope.hpp"

namespace waybreaker::city {
namespace {

// Metres of coastline that may have one face on both sides.
constexpr double tolerance = 1;

std::vector<Line> lines_of(const std::vector<const OGRGeometry*>& coasts, const OGREnvelope& bounds) {
    std::vector<Line> lines;
    for (const OGRGeometry* coast : coasts) {
        const std::optional<geotiff::FeatureParts> parts = geotiff::parts_of(*coast);
        if (!parts) continue;
        for (const Line& line : parts->parts) {
            for (Line& piece : clipped(line, bounds)) lines.push_back(std::move(piece));
        }
    }
    return lines;
}

// How many metres of coastline have a face on their right, and on their left.
struct Sides {
    double right = 0;
    double left = 0;
};

}  // namespace

Sea sea_beside(const std::vector<const OGRGeometry*>& coasts, const OGRPolygon& edge) {
    const geotiff::GdalScope gdal;
    Sea sea;
    OGREnvelope bounds;
    edge.getEnvelope(&bounds);
    std::vector<Line> lines = lines_of(coasts, bounds);
    if (lines.empty()) return sea;
    const std::size_t coastlines = lines.size();
    const double reach = reach_of(edge);
    for (const Point& end : loose_ends(lines)) {
        const Point foot = just_beyond(edge, end);
        if (lies_within(edge, end) && distance(end, foot) <= reach) lines.push_back({end, foot});
    }
    const Faces faces(lines, edge);
    lines.resize(coastlines);
    std::vector<Sides> sides(faces.size());
    for (const Border& border : borders(faces, lines)) {
        if (border.right != Faces::none) sides[border.right].right += border.length;
        if (border.left != Faces::none) sides[border.left].left += border.length;
    }
    for (std::size_t i = 0; i < faces.size(); ++i) {
        if (sides[i].right > tolerance && sides[i].left > tolerance) sea.leaks = true;
        if (sides[i].right > sides[i].left) sea.areas.emplace_back(faces[i].clone());
    }
    return sea;
}

}  // namespace waybreaker::city
