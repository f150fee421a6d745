#include "city/features.hpp"

#include <fmt/format.h>

#include "city/ground_rules.hpp"
#include "city/layer_features.hpp"
#include "city/osm_features.hpp"
#include "labels/obstacle_names.hpp"

namespace waybreaker::city {

FeatureReport visit_features(const std::string& source, const FeatureQuery& query,
                             const std::function<void(Feature)>& visit) {
    if (const std::optional<OsmSource> osm = osm_source(source)) return visit_osm(*osm, query, visit);
    return visit_layers(source, query, visit);
}

std::vector<std::string> kept_tags(const TagSet& tags) {
    std::vector<std::string> kept;
    for (const std::string_view key : kept_keys) {
        const std::string* const said = tags.find(key);
        const std::string text = labels::clean_name(said ? *said : "no");
        if (!text.empty() && !site::says_no(text)) kept.push_back(fmt::format("{}={}", key, text));
    }
    return kept;
}

}  // namespace waybreaker::city
