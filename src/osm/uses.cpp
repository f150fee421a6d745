// Sources of the rows: wiki.openstreetmap.org/wiki/Key:area and the pages of the keys, which say whether a closed way
// is an area; compared with the lists of the editor iD (id-area-keys) and of GDAL (closed_ways_are_polygons).
#include "osm/uses.hpp"

#include <algorithm>
#include <cstring>
#include <osmium/osm/tag.hpp>
#include <string_view>
#include <vector>

namespace waybreaker::osm {
namespace {

// Closed ways with the key are areas if their value is one of these, or if it is none of these; else lines.
enum class Rule { only, all_but };
struct AreaKey {
    std::string_view key;
    Rule rule;
    std::vector<std::string_view> values = {};
};

const std::vector<AreaKey>& area_keys() {
    using enum Rule;
    static const std::vector<AreaKey> keys{
        {"aeroway", all_but, {"taxiway", "jet_bridge"}},
        {"amenity", all_but},
        {"area:highway", all_but},
        {"boundary", all_but},
        {"building", all_but},
        {"building:part", all_but},
        {"club", all_but},
        {"craft", all_but},
        {"emergency", all_but, {"yes", "designated", "official", "private", "permissive", "destination"}},  // of access
        {"geological", all_but},
        {"healthcare", all_but},
        {"highway", only, {"platform", "rest_area", "services"}},
        {"historic", all_but, {"citywalls"}},
        {"landuse", all_but},
        {"leisure", all_but, {"slipway", "track"}},
        {"man_made",
         all_but,
         {"breakwater", "cutline", "dyke", "embankment", "goods_conveyor", "groyne", "pipeline", "yes"}},
        {"military", all_but, {"trench"}},
        {"natural", all_but, {"arete", "cliff", "coastline", "earth_bank", "gully", "ridge", "tree_row", "valley"}},
        {"office", all_but},
        {"place", all_but},
        {"power", only, {"generator", "plant", "substation", "transformer"}},
        {"public_transport", only, {"platform", "station"}},
        {"railway", only, {"platform", "roundhouse", "station", "traverser", "turntable"}},
        {"ruins", all_but},
        {"shop", all_but},
        {"sport", all_but},
        {"tourism", all_but},
        {"waterway", only, {"boatyard", "dam", "dock", "fuel", "riverbank"}},
    };
    return keys;
}

const AreaKey* find_key(const char* key) {
    const auto found = std::ranges::find(area_keys(), std::string_view(key), &AreaKey::key);
    return found == area_keys().end() ? nullptr : &*found;
}

bool holds(const AreaKey& key, const char* value) {
    const bool listed = std::ranges::find(key.values, std::string_view(value)) != key.values.end();
    return listed == (key.rule == Rule::only);
}

}  // namespace

Uses uses_of(const osmium::TagList& tags, bool closed) {
    if (!closed) return {.line = true};
    if (const char* const said = tags.get_value_by_key("area")) {
        if (std::strcmp(said, "yes") == 0) return {.area = true};
        if (std::strcmp(said, "no") == 0) return {.line = true};
    }
    Uses uses;
    for (const osmium::Tag& tag : tags) {
        const AreaKey* const key = find_key(tag.key());
        if (key == nullptr || std::strcmp(tag.value(), "no") == 0) continue;
        (holds(*key, tag.value()) ? uses.area : uses.line) = true;
    }
    if (!uses.area) uses.line = true;
    return uses;
}

bool is_area_key(const char* key) {
    return find_key(key) != nullptr;
}

}  // namespace waybreaker::osm
