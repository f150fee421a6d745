#include "city/bridge_sides.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <set>

#include "city/places.hpp"

namespace waybreaker::city {
namespace {

std::unique_ptr<OGRMultiLineString> lines_in(const OGRGeometry& shape) {
    OGRGeometry* const lines = OGRGeometryFactory::forceToMultiLineString(shape.clone());
    return std::unique_ptr<OGRMultiLineString>(lines->toMultiLineString());
}

// How many lines lead through a place.
using Meetings = std::map<Place, int>;

void count_places(const OGRLineString& line, Meetings& meetings) {
    std::set<Place> places;
    for (const OGRPoint& point : line) places.insert(place_at(point));
    for (const Place& place : places) ++meetings[place];
}

void append_disc(const OGRPoint& centre, double half, OGRMultiPolygon& parts) {
    parts.addGeometryDirectly(centre.Buffer(half, quarter_circle));
}

void append_box(const OGRPoint& a, const OGRPoint& b, double half, OGRMultiPolygon& parts) {
    const double length = std::hypot(b.getX() - a.getX(), b.getY() - a.getY());
    if (length == 0) return;
    const double across = (b.getX() - a.getX()) / length * half;
    const double along = (b.getY() - a.getY()) / length * half;
    auto ring = std::make_unique<OGRLinearRing>();
    ring->addPoint(a.getX() - along, a.getY() + across);
    ring->addPoint(b.getX() - along, b.getY() + across);
    ring->addPoint(b.getX() + along, b.getY() - across);
    ring->addPoint(a.getX() + along, a.getY() - across);
    ring->closeRings();
    auto box = std::make_unique<OGRPolygon>();
    box->addRingDirectly(ring.release());
    parts.addGeometryDirectly(box.release());
}

// A strip that is cut off straight where the line ends, unless another line goes on there.
std::unique_ptr<OGRGeometry> flat_strip(const OGRGeometry& shape, double half, const Meetings& meetings) {
    OGRMultiPolygon parts;
    const std::unique_ptr<OGRMultiLineString> lines = lines_in(shape);
    for (const OGRLineString* line : *lines) {
        for (int i = 0; i < line->getNumPoints(); ++i) {
            OGRPoint point;
            line->getPoint(i, &point);
            const bool end = i == 0 || i + 1 == line->getNumPoints();
            if (!end || meetings.at(place_at(point)) > 1) append_disc(point, half, parts);
            if (i == 0) continue;
            OGRPoint before;
            line->getPoint(i - 1, &before);
            append_box(before, point, half, parts);
        }
    }
    return std::unique_ptr<OGRGeometry>(parts.UnionCascaded());
}

}  // namespace

double opened_reach(double vehicle, double cell) {
    const double half_diagonal = std::sqrt(0.5) * cell;
    return vehicle > cell ? vehicle / 2 + 2 * half_diagonal : half_diagonal;
}

void widen_bridge_sides(std::vector<GroundPiece>& pieces, double cell) {
    const auto is_side = [](const GroundPiece& piece) { return piece.use.layer == GroundLayer::bridge_side; };
    Meetings meetings;
    for (const GroundPiece& piece : pieces) {
        if (!is_side(piece)) continue;
        const std::unique_ptr<OGRMultiLineString> lines = lines_in(*piece.shape);
        for (const OGRLineString* line : *lines) count_places(*line, meetings);
    }
    for (GroundPiece& piece : pieces) {
        if (!is_side(piece)) continue;
        const double opened = std::max(piece.use.breadth / 2, opened_reach(piece.use.width, cell));
        piece.shape = flat_strip(*piece.shape, opened + cell, meetings);
    }
}

}  // namespace waybreaker::city
