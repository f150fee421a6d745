// Ways: which are there, how wide they are, and who may use them.
#include <algorithm>
#include <array>

#include "city/ground_levels.hpp"
#include "city/rule_tables.hpp"
#include "city/vehicle_rules.hpp"

namespace waybreaker::city {
namespace {

using Kind = site::ObstacleKind;
using Shape = site::Background::Shape;

// What a profile does with a class of ways.
enum class Right { drives, ignores, must_not };
constexpr Right drives = Right::drives;
constexpr Right ignores = Right::ignores;
constexpr Right must_not = Right::must_not;

struct WayClass {
    std::string_view highway;
    double width;  // metres, where neither `width` nor `lanes` says it
    Right rover, truck, walker;
};

constexpr std::array way_classes{
    // [Key:highway]
    WayClass{"motorway", 10.5, must_not, drives, must_not},    // median of 2; one carriageway
    WayClass{"motorway_link", 6, must_not, drives, must_not},  // choice
    WayClass{"trunk", 8, must_not, drives, must_not},          // choice
    WayClass{"trunk_link", 6, must_not, drives, must_not},     // choice
    WayClass{"primary", 8, drives, drives, drives},            // choice: of 24 most are in no metres
    WayClass{"primary_link", 5.5, drives, drives, drives},     // choice
    WayClass{"secondary", 6, drives, drives, drives},          // median of 21
    WayClass{"secondary_link", 5.5, drives, drives, drives},   // choice
    WayClass{"tertiary", 7, drives, drives, drives},           // choice; median of 43 is 9
    WayClass{"tertiary_link", 5.5, drives, drives, drives},    // choice
    WayClass{"unclassified", 6.5, drives, drives, drives},     // median of 47
    WayClass{"residential", 7, drives, drives, drives},        // median of 134
    WayClass{"living_street", 5.25, drives, drives, drives},   // median of 20
    WayClass{"road", 6.5, drives, drives, drives},             // of unknown class: as unclassified
    WayClass{"service", 5, drives, drives, drives},            // median of 98
    WayClass{"track", 2.25, drives, drives, drives},           // median of 24
    WayClass{"pedestrian", 3, drives, ignores, drives},        // median of 4
    WayClass{"cycleway", 2.5, drives, ignores, drives},        // choice
    WayClass{"footway", 2, drives, ignores, drives},           // median of 60
    WayClass{"bridleway", 2, drives, ignores, drives},         // choice
    WayClass{"path", 1, drives, ignores, drives},              // median of 169
    WayClass{"steps", 1.5, ignores, ignores, drives}};         // median of 35; wheels do not climb them

constexpr double lane_width = 3.25;  // [Key:lanes] counts lanes; the width is a choice
constexpr double pier_width = 3;     // [Tag:man_made=pier]; choice
constexpr double widest_way = 40;    // above, `width` is in feet or that of the whole street

// Areas made to be driven on, beside those of `highway` and `area:highway`. Not [Key:landuse]=industrial, commercial,
// retail, ...: zones, with buildings, lawns and stores, in which `service` ways are drawn; nor squares, which
// [Tag:highway=pedestrian] and [Tag:place=square] keep for people.
const std::vector<TagFilter>& paved_areas() {
    static const std::vector<TagFilter> areas{
        // [Tag:amenity=parking], [Tag:amenity=parking_space], [Tag:amenity=fuel], [Tag:amenity=bus_station],
        // [Tag:amenity=loading_dock], [Tag:amenity=weighbridge]
        {"amenity", {"parking", "parking_space", "fuel", "bus_station", "loading_dock", "weighbridge"}},
        {"landuse", {"garages", "depot"}}};  // [Tag:landuse=garages], [Tag:landuse=depot]: with their driveways
    return areas;
}

const WayClass* class_called(const std::string* word) {
    const auto* const found = std::find_if(way_classes.begin(), way_classes.end(), [&](const WayClass& one) {
        return word != nullptr && one.highway == *word;
    });
    return found == way_classes.end() ? nullptr : found;
}

double way_width(const TagSet& tags, double usual) {
    const double lanes = tags.number("lanes").value_or(0);
    return width_of(tags, lanes >= 1 ? lanes * lane_width : usual, widest_way);
}

// A ramp for wheelchairs or prams beside steps carries a rover. [Key:ramp]
bool has_ramp(const TagSet& tags) {
    return tags.says("ramp:wheelchair") || tags.says("ramp:stroller");
}

// Motorways that the vehicle's own key opens, pavements that are for deliveries: [Key:access].
Right right_of(const TagSet& tags, const WayClass& way, Profile profile) {
    const Right usual = profile == Profile::truck ? way.truck : profile == Profile::walker ? way.walker : way.rover;
    if (way.highway == "steps") return profile == Profile::rover && has_ramp(tags) ? drives : usual;
    return usual != drives && is_invited(tags, profile) ? drives : usual;
}

// [Tag:bridge=collapsed], [Key:impassable]; stepping stones are for legs: [Tag:ford=stepping_stones].
bool is_usable(const TagSet& tags, Profile profile) {
    if (says_one_of(tags, "bridge", {"collapsed", "abandoned"}) || tags.is("impassable", "yes")) return false;
    return !vehicle(profile).wheels || !tags.is("ford", "stepping_stones");
}

void add_class(const TagSet& tags, const WayClass& way, Shape shape, Profile profile, std::vector<GroundUse>& uses) {
    if (is_elsewhere(tags)) return;
    const double own = vehicle(profile).width;
    const double width = std::max(way_width(tags, way.width), own);
    const Right right = right_of(tags, way, profile);
    const bool on_ground = !in_tunnel(tags) && !in_passage(tags);
    if (right != drives || !may_enter(tags, profile)) {
        const bool closed = right == must_not || is_closed(tags, "access");
        if (closed && shape == Shape::line && on_ground) {
            uses.push_back({GroundLayer::forbidden, Kind::forbidden, width});
        } else if (way.highway == "steps" && shape == Shape::line && on_ground && !is_below(tags)) {
            uses.push_back({GroundLayer::water, Kind::cliff, width});
        }
        return;
    }
    if (!is_usable(tags, profile) || !is_within_limits(tags, profile)) return;
    const bool below = is_below(tags) && !in_passage(tags);
    const bool line = shape == Shape::line;
    const bool over = tags.says("bridge") || tags.says("ford") || tags.says("embankment");
    if (on_bridge(tags) && line) {
        uses.push_back({.layer = GroundLayer::bridge_side, .kind = Kind::cliff, .width = own, .breadth = width});
    }
    const bool bridge = tags.says("bridge") && !below;
    if (over && !below) uses.push_back({.layer = GroundLayer::way_over, .width = width, .bridge = bridge});
    if (!below && !in_tunnel(tags)) uses.push_back({.layer = GroundLayer::road, .width = width});
    // Without the line in its middle an area opens what it lies over, but no fence or house that stands on it.
    if (!line) return;
    uses.push_back({.layer = in_tunnel(tags) || below ? GroundLayer::underpass : GroundLayer::way,
                    .width = own,
                    .breadth = width,
                    .bridge = bridge});
}

// Whether an area is ground made for the profile to drive on; not a house, such as a garage.
bool is_paved(const TagSet& tags, Profile profile) {
    if (stands_in_the_way(tags)) return false;
    const WayClass* const drawn = class_called(tags.find("area:highway"));
    const auto fits = [&](const TagFilter& filter) { return tags.matches(filter); };
    return (drawn != nullptr && right_of(tags, *drawn, profile) == drives) ||
           std::any_of(paved_areas().begin(), paved_areas().end(), fits);
}

}  // namespace

bool keeps_to_roads(Profile profile) {
    return profile == Profile::truck;
}

double width_of(const TagSet& tags, double usual, double widest) {
    const double width = tags.number("width").value_or(0);
    return width > 0 && width <= widest ? width : usual;
}

bool add_way(const TagSet& tags, Shape shape, Profile profile, std::vector<GroundUse>& uses) {
    if (const WayClass* const way = class_called(tags.find("highway"))) {
        add_class(tags, *way, shape, profile, uses);
        return true;
    }
    if (!may_enter(tags, profile)) return false;
    const bool on_ground = !is_elsewhere(tags) && !is_below(tags) && !in_tunnel(tags);
    if (shape == Shape::area && on_ground && is_paved(tags, profile)) uses.push_back({.layer = GroundLayer::road});
    if (!keeps_to_roads(profile) && tags.is("man_made", "pier")) {
        const double width = way_width(tags, pier_width);
        uses.push_back({.layer = GroundLayer::way_over, .width = width});
        uses.push_back({.layer = GroundLayer::road, .width = width});
        if (shape == Shape::line) {
            uses.push_back({.layer = GroundLayer::way, .width = vehicle(profile).width, .breadth = width});
        }
    }
    return false;
}

}  // namespace waybreaker::city
