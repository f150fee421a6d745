#include "city/edge_faces.hpp"

#include <ogr_api.h>

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

namespace waybreaker::city {
namespace {

// Metres beside a line where one looks what lies there.
constexpr double step_aside = 0.01;

OGRLineString line_string(const Line& line) {
    OGRLineString result;
    for (const Point& point : line) result.addPoint(point.x, point.y);
    return result;
}

}  // namespace

double reach_of(const OGRPolygon& edge) {
    constexpr double farthest = 200;
    constexpr double share = 0.15;  // of the shorter side, so that small extracts keep an inside
    OGREnvelope box;
    edge.getEnvelope(&box);
    return std::min(farthest, share * std::min(box.MaxX - box.MinX, box.MaxY - box.MinY));
}

Point just_beyond(const OGRPolygon& edge, const Point& from) {
    constexpr double beyond = 0.05;  // metres
    const OGRLinearRing& ring = *edge.getExteriorRing();
    const double outwards = ring.isClockwise() ? -1 : 1;  // which side of the ring's segments: 1 for the right
    double least = std::numeric_limits<double>::infinity();
    Point result = from;
    for (int i = 1; i < ring.getNumPoints(); ++i) {
        const Point a{ring.getX(i - 1), ring.getY(i - 1)};
        const Point along{ring.getX(i) - a.x, ring.getY(i) - a.y};
        const double length = distance(a, {ring.getX(i), ring.getY(i)});
        if (!(length > 0)) continue;
        const double share =
            std::clamp(((from.x - a.x) * along.x + (from.y - a.y) * along.y) / (length * length), 0.0, 1.0);
        const Point foot{a.x + share * along.x, a.y + share * along.y};
        if (distance(from, foot) >= least) continue;
        least = distance(from, foot);
        const double step = outwards * beyond / length;
        result = {foot.x + along.y * step, foot.y - along.x * step};
    }
    return result;
}

std::vector<Point> loose_ends(const std::vector<Line>& lines) {
    std::map<std::pair<double, double>, int> counts;
    for (const Line& line : lines) {
        if (line.empty()) continue;
        for (const Point& end : {line.front(), line.back()}) ++counts[{end.x, end.y}];
    }
    std::vector<Point> ends;
    for (const auto& [at, count] : counts) {
        if (count == 1) ends.emplace_back(at.first, at.second);
    }
    return ends;
}

bool lies_within(const OGRPolygon& edge, const Point& point) {
    const OGRPoint at(point.x, point.y);
    return edge.getExteriorRing()->isPointInRing(&at) || edge.getExteriorRing()->isPointOnRingBoundary(&at);
}

Faces::Faces(const std::vector<Line>& lines, const OGRPolygon& edge) {
    OGRMultiLineString cuts;
    for (const Line& line : lines) {
        const OGRLineString cut = line_string(line);
        cuts.addGeometry(&cut);
    }
    OGRLineString ring;
    ring.addSubLineString(edge.getExteriorRing());
    const std::unique_ptr<OGRGeometry> noded(cuts.Union(&ring));
    const std::unique_ptr<OGRGeometry> polygons(noded ? noded->Polygonize() : nullptr);
    if (!polygons) return;
    for (const OGRGeometry* polygon : *polygons->toGeometryCollection()) {
        Face face{std::unique_ptr<OGRGeometry>(polygon->clone()), {}, nullptr};
        const std::unique_ptr<OGRGeometry> inside(
            OGRGeometry::FromHandle(OGR_G_PointOnSurface(OGRGeometry::ToHandle(face.shape.get()))));
        if (!inside || inside->IsEmpty()) continue;
        if (!lies_within(edge, {inside->toPoint()->getX(), inside->toPoint()->getY()})) continue;
        face.shape->getEnvelope(&face.box);
        face.prepared.reset(OGRCreatePreparedGeometry(OGRGeometry::ToHandle(face.shape.get())));
        faces_.push_back(std::move(face));
    }
}

std::size_t Faces::at(const Point& point) const {
    OGRPoint place(point.x, point.y);
    const auto found = std::find_if(faces_.begin(), faces_.end(), [&](const Face& face) {
        return point.x >= face.box.MinX && point.x <= face.box.MaxX && point.y >= face.box.MinY &&
               point.y <= face.box.MaxY &&
               OGRPreparedGeometryContains(face.prepared.get(), OGRGeometry::ToHandle(&place));
    });
    return found == faces_.end() ? none : std::size_t(found - faces_.begin());
}

std::vector<Border> borders(const Faces& faces, const std::vector<Line>& lines) {
    std::vector<Border> result;
    for (const Line& line : lines) {
        for (std::size_t i = 1; i < line.size(); ++i) {
            const Point& a = line[i - 1];
            const Point& b = line[i];
            const double length = distance(a, b);
            if (!(length > 0)) continue;
            const double x = (a.x + b.x) / 2;
            const double y = (a.y + b.y) / 2;
            const double east = (b.y - a.y) / length * step_aside;  // of the right-hand side
            const double north = (a.x - b.x) / length * step_aside;
            result.push_back({faces.at({x - east, y - north}), faces.at({x + east, y + north}), length});
        }
    }
    return result;
}

}  // namespace waybreaker::city
