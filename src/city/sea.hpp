// The sea beside coastlines.
#pragma once

#include <ogr_geometry.h>

#include <memory>
#include <vector>

namespace waybreaker::city {

struct Sea {
    std::vector<std::unique_ptr<OGRGeometry>> areas;  // within the edge
    bool leaks = false;  // coastlines end within it, so that land and sea cannot be told apart everywhere
};

// By OpenStreetMap's rule: the water lies to the right of a coastline. The edge, which is convex, closes it.
Sea sea_beside(const std::vector<const OGRGeometry*>& coasts, const OGRPolygon& edge);

}  // namespace waybreaker::city
