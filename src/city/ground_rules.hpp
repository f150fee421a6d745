// What a vehicle can drive on, by OpenStreetMap's tags: kinds, widths and profiles. The tables are in way_rules.cpp
// (ways, and where trucks drive beside them), block_rules.cpp (what bars) and point_rules.cpp (barriers that are
// points); docs/data.md explains them in plain words.
//
// Sources of their rows: [Key:...] and [Tag:...] are pages of wiki.openstreetmap.org, which say what a tag means.
// "Median of n" is the median of the tag `width` over n ways of the extracts that the project tests with, "of n areas"
// that of the widths of waters that are drawn as areas there. Other widths are choices: round numbers near what one
// sees in a street.
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "city/tag_set.hpp"
#include "site/background.hpp"
#include "site/obstacle_kinds.hpp"
#include "site/profile.hpp"

namespace waybreaker::city {

using site::Profile;

// What a feature does to the cells it covers; ground_map.hpp says in which order.
enum class GroundLayer {
    bridge_side,  // blocks, for ever, beside the way that the bridge carries
    water,        // likewise; also steps of the ground
    way_over,     // opens water, and sides of bridges
    forbidden,    // blocks, for ever
    closed,       // likewise, and no way leads across
    barrier,      // blocks, until it is destroyed; of points, what stands in a way
    gate,         // opens barriers
    underpass,    // opens forbidden lines, and sides of bridges
    way,          // opens everything
    shut,         // a point where ways open nothing
    road  // opens nothing: the ground of a way as wide as it is, and what is as good as a way, such as a car park
};

struct GroundUse {
    GroundLayer layer;
    site::ObstacleKind kind = site::ObstacleKind::unknown;  // of a layer that blocks
    double width = 0;                                       // of a line, in metres; see breadth
    bool outline = false;                                   // of an area only its outline counts
    bool drawn_as_area = false;                             // where an area covers it, a line says nothing new
    // Of a way or a side of a bridge the metres that the way is wide; `width` is then what the vehicle needs.
    double breadth = 0;
    bool bridge = false;  // of a way: no flood reaches it
};

// What a feature of that shape is to the profile; mostly nothing.
std::vector<GroundUse> ground_uses(const TagSet& tags, site::Background::Shape shape, Profile profile);

// Whether the profile drives on roads and nowhere else.
bool keeps_to_roads(Profile profile);

// Of a feature with the tag `building`: whether it stands on the ground and bars the way.
bool stands_in_the_way(const TagSet& building);

// Buildings and barriers that a profile does not destroy, and what they are called.
struct Protection {
    std::vector<TagFilter> filters;
    std::string_view text;
};
const Protection& protection(Profile profile);

// Whether what a point says by that key holds for the building around it.
bool holds_around_point(std::string_view key, const TagSet& point);

// Keys of the tags that maps keep of obstacles, so that people can name these by what they are.
inline constexpr std::array<std::string_view, 6> kept_keys{"amenity",  "barrier",  "building",
                                                           "heritage", "historic", "tourism"};

// Every key by which a feature of that shape, or of any, can have a use.
const std::vector<TagFilter>& ground_keys(std::optional<site::Background::Shape> shape);

// Tunnels above that length, in metres, lead elsewhere than across.
inline constexpr double longest_underpass = 100;

}  // namespace waybreaker::city
