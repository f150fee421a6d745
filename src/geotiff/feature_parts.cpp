#include "geotiff/feature_parts.hpp"

#include <algorithm>

namespace waybreaker::geotiff {
namespace {

using Parts = std::vector<std::vector<Point>>;

std::vector<Point> points_of(const OGRSimpleCurve& curve) {
    std::vector<Point> points;
    for (int i = 0; i < curve.getNumPoints(); ++i) points.emplace_back(curve.getX(i), curve.getY(i));
    return points;
}

void append_polygon(const OGRPolygon& polygon, Parts& parts) {
    bool left = true;
    for (const OGRLinearRing* ring : polygon) {
        std::vector<Point> points = points_of(*ring);
        if (points.size() > 1 && points.front() == points.back()) points.pop_back();
        if (points.size() < 3) {
            if (left) return;  // nothing to have a hole in
            continue;
        }
        if ((signed_area(points) > 0) != left) std::reverse(points.begin(), points.end());
        parts.push_back(std::move(points));
        left = false;
    }
}

void append_line(const OGRLineString& line, Parts& parts) {
    if (line.getNumPoints() > 1) parts.push_back(points_of(line));
}

void append_point(const OGRPoint& point, Parts& parts) {
    if (!point.IsEmpty()) parts.push_back({{point.getX(), point.getY()}});
}

}  // namespace

double signed_area(const std::vector<Point>& ring) {
    double twice = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point& next = ring[(i + 1) % ring.size()];
        twice += ring[i].x * next.y - next.x * ring[i].y;
    }
    return twice / 2;
}

std::optional<FeatureParts> parts_of(const OGRGeometry& shape) {
    Parts parts;
    switch (wkbFlatten(shape.getGeometryType())) {
        case wkbPoint:
            append_point(*shape.toPoint(), parts);
            return FeatureParts{site::Background::Shape::point, std::move(parts)};
        case wkbMultiPoint:
            for (const OGRPoint* point : *shape.toMultiPoint()) append_point(*point, parts);
            return FeatureParts{site::Background::Shape::point, std::move(parts)};
        case wkbLineString:
            append_line(*shape.toLineString(), parts);
            return FeatureParts{site::Background::Shape::line, std::move(parts)};
        case wkbMultiLineString:
            for (const OGRLineString* line : *shape.toMultiLineString()) append_line(*line, parts);
            return FeatureParts{site::Background::Shape::line, std::move(parts)};
        case wkbPolygon:
            append_polygon(*shape.toPolygon(), parts);
            return FeatureParts{site::Background::Shape::area, std::move(parts)};
        case wkbMultiPolygon:
            for (const OGRPolygon* polygon : *shape.toMultiPolygon()) append_polygon(*polygon, parts);
            return FeatureParts{site::Background::Shape::area, std::move(parts)};
        default:
            return std::nullopt;
    }
}

}  // namespace waybreaker::geotiff
