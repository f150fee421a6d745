// What a vehicle can drive on, by OpenStreetMap's tags: the one table of kinds, widths and profiles. docs/data.md
// explains it in plain words.
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "city/tag_set.hpp"
#include "site/background.hpp"
#include "site/obstacle_kinds.hpp"

namespace waybreaker::city {

// Who drives. `paper`: nobody in particular; buildings are all there is, as in the paper.
enum class Profile { rover, truck, walker, paper };

// What a feature does to the cells it covers; ground_map.hpp says in which order.
enum class GroundLayer {
    water,      // blocks, for ever; also steps of the ground
    way_over,   // opens water
    forbidden,  // blocks, for ever
    closed,     // likewise, and no way leads across
    barrier,    // blocks, until it is destroyed
    gate,       // opens barriers
    underpass,  // opens forbidden lines
    way         // opens everything
};

struct GroundUse {
    GroundLayer layer;
    site::ObstacleKind kind = site::ObstacleKind::unknown;  // of a layer that blocks
    double width = 0;                                       // of a line, in metres; of a way, what the vehicle needs
    bool outline = false;                                   // of an area only its outline counts
    bool drawn_as_area = false;                             // where an area covers it, a line says nothing new
    bool bridge = false;                                    // of a way: no flood reaches it
};

// What a feature of that shape is to the profile; mostly nothing.
std::vector<GroundUse> ground_uses(const TagSet& tags, site::Background::Shape shape, Profile profile);

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

// Metres.
double vehicle_width(Profile profile);

// Tunnels above that length, in metres, lead elsewhere than across.
inline constexpr double longest_underpass = 100;

}  // namespace waybreaker::city
