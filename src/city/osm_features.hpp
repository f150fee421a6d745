// OpenStreetMap's own data as features.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "city/features.hpp"
#include "osm/features.hpp"

namespace waybreaker::city {

// A source as a file that libosmium can open.
struct OsmSource {
    std::string name;
    osm::File file;
    std::shared_ptr<const void> kept = {};  // the file lives as long, if it is only in memory
};

// Empty if the source is something else; its content decides.
std::optional<OsmSource> osm_source(const std::string& source);

// As visit_features; points first, then areas of relations, then ways.
FeatureReport visit_osm(const OsmSource& source, const FeatureQuery& query, const std::function<void(Feature)>& visit);

}  // namespace waybreaker::city
