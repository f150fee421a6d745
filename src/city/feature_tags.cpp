#include "city/feature_tags.hpp"

#include <fmt/format.h>

#include <optional>
#include <string_view>
#include <utility>

#include "city/geofabrik.hpp"

namespace waybreaker::city {
namespace {

// The text in quotes at a position, which moves past them; empty if there is none.
std::optional<std::string> take_quoted(std::string_view text, std::size_t& at) {
    if (at >= text.size() || text[at] != '"') return std::nullopt;
    std::string value;
    for (++at; at < text.size() && text[at] != '"'; ++at) {
        if (text[at] == '\\' && at + 1 < text.size()) ++at;
        value += text[at];
    }
    ++at;
    return value;
}

}  // namespace

FeatureTags::FeatureTags(OGRLayer& layer)
    : definition_(*layer.GetLayerDefn()),
      way_(definition_.GetFieldIndex("osm_way_id")),
      osm_(definition_.GetFieldIndex("osm_id")),
      other_(definition_.GetFieldIndex("other_tags")),
      geofabrik_(geofabrik_key(layer)) {}

bool FeatureTags::can_have(const std::string& key) const {
    if (!geofabrik_.empty() && (key == geofabrik_ || (key == "leisure" && geofabrik_ == "landuse"))) return true;
    return other_ >= 0 || definition_.GetFieldIndex(key.c_str()) >= 0;
}

std::string FeatureTags::condition(const std::vector<TagFilter>& filters) const {
    if (!geofabrik_.empty()) return "";
    std::string text;
    for (const TagFilter& filter : filters) {
        if (filter.key == "*") return "";
        if (!can_have(filter.key)) continue;
        if (!text.empty()) text += " OR ";
        const bool own = definition_.GetFieldIndex(filter.key.c_str()) >= 0;
        text += own ? fmt::format("\"{}\" IS NOT NULL", filter.key)
                    : fmt::format("other_tags LIKE '%\"{}\"=>%'", filter.key);
    }
    return text;
}

TagSet FeatureTags::all(const OGRFeature& feature) const {
    std::vector<std::pair<std::string, std::string>> tags;
    for (int i = 0; i < definition_.GetFieldCount(); ++i) {
        if (i == other_ || !feature.IsFieldSetAndNotNull(i)) continue;
        tags.emplace_back(definition_.GetFieldDefn(i)->GetNameRef(), feature.GetFieldAsString(i));
    }
    const std::string_view pairs =
        other_ >= 0 && feature.IsFieldSetAndNotNull(other_) ? feature.GetFieldAsString(other_) : "";
    for (std::size_t at = 0; at < pairs.size(); ++at) {  // past the comma
        std::optional<std::string> key = take_quoted(pairs, at);
        at += 2;  // =>
        std::optional<std::string> value = take_quoted(pairs, at);
        if (!key || !value) break;
        tags.emplace_back(std::move(*key), std::move(*value));
    }
    if (!geofabrik_.empty()) tags = geofabrik_tags(geofabrik_, tags);
    return TagSet(std::move(tags), TagSet::Case::ignored);  // as columns of databases have it
}

// GDAL's OSM driver gives ways and relations a field each; elsewhere osm_id is what it is. Lines have ways alone.
std::int64_t FeatureTags::source_id(const OGRFeature& feature) const {
    if (way_ >= 0 && feature.IsFieldSetAndNotNull(way_)) return feature.GetFieldAsInteger64(way_);
    if (osm_ < 0 || !feature.IsFieldSetAndNotNull(osm_)) return 0;
    const std::int64_t id = feature.GetFieldAsInteger64(osm_);
    return way_ >= 0 ? -id : id;
}

}  // namespace waybreaker::city
