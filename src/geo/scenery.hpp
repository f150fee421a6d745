// Scenery: what a vector source knows of a window beside its obstacles, by OpenStreetMap's tags: streets, railways,
// water, green, places.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "geo/vector_source.hpp"
#include "site/background.hpp"

namespace waybreaker::geo {

struct Sight {
    site::Background::Kind kind;
    int rank = 0;  // 0 is what a map of a whole city shows, 3 what only one of a few streets does
    std::string type;
    std::string name;
    std::unique_ptr<OGRGeometry> shape;  // in the window's system, not clipped
};

// In the source's order; one scan of it, none if nothing in it can have such tags. Nothing in tunnels. Throws
// InputError if the source cannot be read.
std::vector<Sight> read_scenery(const std::string& source, const Window& window);

// What of it lies within bounds, in the cells of a map there: joined, clipped, simplified to half a cell (areas: a
// cell), without what is too small to see. The least ranks are left out where it would be too long for the file.
site::Background background_within(const std::vector<Sight>& scenery, const OGREnvelope& bounds, double cell);

}  // namespace waybreaker::geo
