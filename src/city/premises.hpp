// Premises: areas and points whose tags protect the buildings there, such as the grounds of a hospital.
#pragma once

#include <ogr_geometry.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "city/import_window.hpp"
#include "city/obstacle_choice.hpp"
#include "city/tag_set.hpp"
#include "site/background.hpp"

namespace waybreaker::city {

// The tags of premises, each of one value or of any; without `building`, which grounds are not.
std::vector<TagFilter> premises_filters(const ObstacleChoice& choice);

struct PremisesTag {
    std::size_t filter;  // of these, that it fits
    std::string key;
    std::string value;
};

// Whether one of the tags fits one of the filters.
bool any_fits(const std::vector<PremisesTag>& tags, const std::vector<TagFilter>& filters);

struct Premises {
    std::unique_ptr<OGRGeometry> shape;  // an area or a point, in the window's system, not clipped
    std::string name;
    std::vector<PremisesTag> tags;
};

// What a feature of that shape says for the buildings there, without its shape; mostly nothing.
std::optional<Premises> premises_of(const TagSet& tags, site::Background::Shape shape,
                                    const std::vector<TagFilter>& filters);

// What a building has of the premises that it stands on.
struct Inheritance {
    std::vector<PremisesTag> tags = {};
    std::string name = {};
};

// Of the shapes with the numbers 1, 2, ... in `labels`, the cells of the window; null for what inherits nothing. A
// building inherits a filter's tag if more than half of its cells have their centres in areas with it, from the area
// that has most of them (where areas overlap, the smallest has a cell); and the tags of points within.
std::vector<Inheritance> inherited(const std::vector<const OGRGeometry*>& buildings,
                                   const std::vector<std::uint32_t>& labels, const CellWindow& window,
                                   const std::vector<Premises>& premises, const std::vector<TagFilter>& filters);

}  // namespace waybreaker::city
