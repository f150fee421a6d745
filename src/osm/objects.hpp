// What of libosmium's objects is wanted, and where it lies.
#pragma once

#include <algorithm>
#include <optional>
#include <osmium/osm/location.hpp>
#include <osmium/osm/node_ref_list.hpp>
#include <osmium/osm/tag.hpp>

#include "osm/features.hpp"
#include "osm/node_places.hpp"

namespace waybreaker::osm {

inline bool wants(const std::optional<Keys>& keys, const osmium::TagList& tags) {
    if (!keys) return false;
    return keys->any_of.empty() ||
           std::ranges::any_of(keys->any_of, [&](const std::string& key) { return tags.has_key(key.c_str()); });
}

inline Tags tags_of(const osmium::TagList& list) {
    Tags tags;
    for (const osmium::Tag& tag : list) tags.emplace_back(tag.key(), tag.value());
    return tags;
}

inline Place place_of(osmium::Location location) {
    return {location.lon_without_check(), location.lat_without_check()};
}

// Grows around places.
class Around {
  public:
    void add(const Place& place) {
        box_.west = std::min(box_.west, place.longitude);
        box_.south = std::min(box_.south, place.latitude);
        box_.east = std::max(box_.east, place.longitude);
        box_.north = std::max(box_.north, place.latitude);
    }
    void add(const Line& line) {
        for (const Place& place : line) add(place);
    }
    bool meets(const std::optional<Box>& box) const {
        return !box || (box_.west <= box->east && box_.east >= box->west && box_.south <= box->north &&
                        box_.north >= box->south);
    }

    // Empty if there are none.
    std::optional<Box> box() const { return box_.west <= box_.east ? std::optional(box_) : std::nullopt; }

  private:
    Box box_{400, 400, -400, -400};
};

// Where a node of a way lies: as the file has the node, or else as it has the way. Invalid if it says neither.
inline osmium::Location location_of(const osmium::NodeRef& node, const NodePlaces& places) {
    const osmium::Location location = places.find(node.ref());
    return location.valid() ? location : node.location();
}

}  // namespace waybreaker::osm
