#include "city/geofabrik.hpp"

#include <algorithm>
#include <array>

namespace waybreaker::city {
namespace {

using Tag = std::pair<std::string, std::string>;

// By a word of the layer's name: gis_osm_roads_free_1.
constexpr std::array<std::pair<std::string_view, std::string_view>, 6> keys{{{"buildings", "building"},
                                                                             {"roads", "highway"},
                                                                             {"railways", "railway"},
                                                                             {"water", "natural"},
                                                                             {"waterways", "waterway"},
                                                                             {"landuse", "landuse"}}};

bool has_word(std::string_view name, std::string_view word) {
    const auto parts = [](char c) { return c == '_' || c == '.'; };
    for (std::size_t at = name.find(word); at != std::string_view::npos; at = name.find(word, at + 1)) {
        const std::size_t end = at + word.size();
        if ((at == 0 || parts(name[at - 1])) && (end == name.size() || parts(name[end]))) return true;
    }
    return false;
}

// What features of that class are called in OpenStreetMap.
Tag tag_of(std::string_view key, const std::string& fclass) {
    if (key == "building") return {"building", "yes"};
    if (key == "highway" && fclass.starts_with("track_")) return {"highway", "track"};
    if (key == "highway" && fclass == "unknown") return {"highway", "road"};
    if (key == "natural" && (fclass == "glacier" || fclass == "wetland")) return {"natural", fclass};
    if (key == "natural") return {"natural", "water"};
    if (key == "landuse" && (fclass == "park" || fclass == "nature_reserve")) return {"leisure", fclass};
    return {std::string(key), fclass};
}

}  // namespace

std::string_view geofabrik_key(OGRLayer& layer) {
    const OGRFeatureDefn& definition = *layer.GetLayerDefn();
    for (const char* field : {"osm_id", "code", "fclass"}) {
        if (definition.GetFieldIndex(field) < 0) return {};
    }
    const auto* const found =
        std::ranges::find_if(keys, [&](const auto& one) { return has_word(layer.GetName(), one.first); });
    return found == keys.end() ? std::string_view() : found->second;
}

std::vector<Tag> geofabrik_tags(std::string_view key, const std::vector<Tag>& attributes) {
    std::vector<Tag> tags;
    for (const auto& [name, value] : attributes) {
        if (name == "fclass") tags.push_back(tag_of(key, value));
        const bool flag = name == "bridge" || name == "tunnel";
        tags.emplace_back(name, flag ? (value == "T" ? "yes" : "no") : value);
    }
    return tags;
}

}  // namespace waybreaker::city
