// Premises: areas and points whose tags protect the buildings there, such as the grounds of a hospital.
#pragma once

#include <ogr_geometry.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "geo/ground_rules.hpp"
#include "geo/import_window.hpp"

namespace waybreaker::geo {

// A tag of one value, or of any, that protects what stands where it is said.
struct PremisesFilter {
    TagFilter tag;
    bool kept = false;      // maps keep it
    bool shelters = false;  // from destruction, though nobody said so
    bool spares = false;    // from destruction, as the user wants it
};

// Those of the profile and those that the user names, but for `building`: that is not said of grounds.
std::vector<PremisesFilter> premises_filters(Profile profile, const ObstacleChoice& choice);

struct Premises {
    std::unique_ptr<OGRGeometry> shape;  // an area or a point, in the window's system, not clipped
    std::string name;
    struct Mark {
        std::size_t filter;
        std::string tag;  // "amenity=hospital"
    };
    std::vector<Mark> marks;
};

// What a feature of that shape protects, without its shape; mostly nothing.
std::optional<Premises> premises_of(const TagSet& tags, site::Background::Shape shape,
                                    const std::vector<PremisesFilter>& filters);

// What a building has of the premises that it stands on.
struct Inheritance {
    std::vector<std::string> tags = {};
    std::string name = {};
    bool sheltered = false;
    bool spared = false;
};

// Of the shapes with the numbers 1, 2, ... in `labels`, the cells of the window; null for what inherits nothing. A
// building inherits a filter's tag if more than half of its cells have their centres in areas with it, from the area
// that has most of them (where areas overlap, the smallest has a cell); and the tags of points within.
std::vector<Inheritance> inherited(const std::vector<const OGRGeometry*>& buildings,
                                   const std::vector<std::uint32_t>& labels, const CellWindow& window,
                                   const std::vector<Premises>& premises, const std::vector<PremisesFilter>& filters);

}  // namespace waybreaker::geo
