// The tags of a layer's features: in attributes, in those of Geofabrik's layers, or in the `other_tags` that GDAL makes
// of OpenStreetMap's rarer tags when it converts such data to layers.
#pragma once

#include <ogrsf_frmts.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "city/obstacle_choice.hpp"
#include "city/tag_set.hpp"

namespace waybreaker::city {

class FeatureTags {
  public:
    explicit FeatureTags(OGRLayer& layer);

    bool from_osm() const { return way_ >= 0 || osm_ >= 0; }
    // Whether the layer says what its features are, so that they are not all buildings.
    bool tells_buildings() const { return !geofabrik_.empty() || can_have("building"); }
    // Whether features can have the tag at all.
    bool can_have(const std::string& key) const;
    // GDAL's condition that passes all features with one of the filters' keys; empty: it cannot be expressed.
    std::string condition(const std::vector<TagFilter>& filters) const;

    TagSet all(const OGRFeature& feature) const;

    // OSM ways positive, relations negative; 0 if the layer does not say.
    std::int64_t source_id(const OGRFeature& feature) const;

  private:
    OGRFeatureDefn& definition_;
    int way_;
    int osm_;
    int other_;
    std::string_view geofabrik_;  // the key of such a layer
};

}  // namespace waybreaker::city
