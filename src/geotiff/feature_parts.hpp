// The lists of points that OGR's geometries are made of, without OGR.
#pragma once

#include <ogr_geometry.h>

#include <optional>
#include <vector>

#include "site/background.hpp"

namespace waybreaker::geotiff {

struct FeatureParts {
    site::Background::Shape shape;
    // As site::Background has them, in the geometry's own coordinates; outer rings turn left where y goes up.
    std::vector<std::vector<Point>> parts;
};

// Of a ring that closes by itself; positive if it turns left where y goes up.
double signed_area(const std::vector<Point>& ring);

// Empty unless it is a point, a line, a polygon, or several of one of these.
std::optional<FeatureParts> parts_of(const OGRGeometry& shape);

}  // namespace waybreaker::geotiff
