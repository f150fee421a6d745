// Scenery: what a reader of a map recognises a place by, by OpenStreetMap's tags: streets, railways, water, green,
// places.
#pragma once

#include <ogr_geometry.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "city/tag_set.hpp"
#include "site/background.hpp"

namespace waybreaker::city {

struct Sight {
    site::Background::Kind kind;
    int rank = 0;  // 0 is what a map of a whole city shows, 3 what only one of a few streets does
    std::string type;
    std::string name;
    std::unique_ptr<OGRGeometry> shape;  // in the window's system, not clipped
};

// What a feature of that shape shows, without its shape; most features are no scenery.
std::optional<Sight> sight_of(const TagSet& tags, site::Background::Shape shape);

// Every key by which a feature of that shape, or of any, can be scenery.
std::vector<TagFilter> scenery_keys(std::optional<site::Background::Shape> shape);

// What of it lies within bounds, in the cells of a map there: joined, clipped, simplified to half a cell (areas: a
// cell), without what is too small to see. The least ranks are left out where it would be too long for the file.
site::Background background_within(const std::vector<Sight>& scenery, const OGREnvelope& bounds, double cell);

}  // namespace waybreaker::city
