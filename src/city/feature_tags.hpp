// The tags of a layer's features: in attributes, or in the `other_tags` that GDAL makes of
// OpenStreetMap's rarer tags.
#pragma once

#include <ogrsf_frmts.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "city/obstacle_choice.hpp"
#include "city/tag_set.hpp"
#include "waybreaker/map.hpp"

namespace waybreaker::city {

// The value of a key in a text of "key"=>"value" pairs, as PostgreSQL's hstore writes them.
std::optional<std::string> hstore_value(std::string_view pairs, std::string_view key);

class FeatureTags {
  public:
    explicit FeatureTags(OGRLayer& layer);

    bool from_osm() const { return way_ >= 0 || osm_ >= 0; }
    // Whether features can have the tag at all.
    bool can_have(const std::string& key) const;
    // GDAL's condition that passes all features with one of the filters' keys; empty: it cannot be expressed.
    std::string condition(const std::vector<TagFilter>& filters) const;

    std::optional<std::string> value(const OGRFeature& feature, const std::string& key) const;
    bool matches_any(const OGRFeature& feature, const std::vector<TagFilter>& filters) const;
    TagSet all(const OGRFeature& feature) const;
    // "key=value" for each of the keys that maps keep and that says something.
    std::vector<std::string> kept(const OGRFeature& feature) const;
    // The number a tag begins with ("12 m").
    std::optional<double> number(const OGRFeature& feature, const std::string& key) const;

    // OSM ways positive, relations negative; 0 if the layer does not say.
    std::int64_t source_id(const OGRFeature& feature) const;

  private:
    OGRFeatureDefn& definition_;
    int way_;
    int osm_;
    int other_;
};

}  // namespace waybreaker::city
