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
        const double turned = place.longitude < 0 ? place.longitude + 360 : place.longitude;
        turned_west_ = std::min(turned_west_, turned);
        turned_east_ = std::max(turned_east_, turned);
    }
    void add(const Line& line) {
        for (const Place& place : line) add(place);
    }
    bool meets(const std::optional<Box>& box) const {
        return !box || (box_.west <= box->east && box_.east >= box->west && box_.south <= box->north &&
                        box_.north >= box->south);
    }

    // The narrower one, whose east is above 180 where it crosses 180 degrees. Empty if there are no places.
    std::optional<Box> box() const {
        if (box_.west > box_.east) return std::nullopt;
        if (turned_east_ - turned_west_ >= box_.east - box_.west) return box_;
        return Box{turned_west_, box_.south, turned_east_, box_.north};
    }

  private:
    Box box_{400, 400, -400, -400};
    double turned_west_ = 400;  // longitudes from 0 to 360
    double turned_east_ = -400;
};

// Where a node of a way lies: as the file has the node, or else as it has the way. Invalid if it says neither.
inline osmium::Location location_of(const osmium::NodeRef& node, const NodePlaces& places) {
    const osmium::Location location = places.find(node.ref());
    return location.valid() ? location : node.location();
}

}  // namespace waybreaker::osm
