// Sources of the rows. [K:...] is the page Key:... of wiki.openstreetmap.org, which says what a tag means. "Median of
// n" is the median of the tag `width` over n ways of the extracts that the project tests with, "of n areas" that of the
// widths of waters that are drawn as areas there. Other widths are choices: round numbers near what one sees in a
// street.
#include "city/ground_rules.hpp"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <string>

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
    // [K:highway]
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

constexpr double lane_width = 3.25;   // [K:lanes] counts lanes; the width is a choice
constexpr double pier_width = 3;      // [Tag:man_made=pier]; choice
constexpr double widest_way = 40;     // above, `width` is in feet or that of the whole street
constexpr double widest_river = 500;  // above, `width` is in other units

struct Vehicle {
    double width;  // metres
    // Keys that tell the vehicle what the general `access` does not. [K:access]
    std::vector<std::string_view> modes;
};

// A rover is a robot on wheels that pavements are made for; a truck is as wide as the law lets one be (2.55 m:
// Directive 96/53/EC); a walker has legs.
const Vehicle& vehicle(Profile profile) {
    static const Vehicle rover{0.8, {"foot"}};
    static const Vehicle truck{2.55, {"hgv", "motor_vehicle", "vehicle"}};
    static const Vehicle walker{0.6, {"foot"}};
    return profile == Profile::truck ? truck : profile == Profile::walker ? walker : rover;
}

// Features of these shapes with that tag block.
struct Blocking {
    GroundLayer layer;
    Kind kind;
    std::vector<Shape> shapes;
    TagFilter filter;
    double width = 0;  // metres, where a line does not say it; every strip has at least a cell
};

// The first row that matches applies.
const std::vector<Blocking>& grounds() {
    constexpr Shape area = Shape::area;
    constexpr Shape line = Shape::line;
    using enum GroundLayer;
    static const std::vector<Blocking> rows{
        // [K:military], [Tag:landuse=military]
        {closed, Kind::forbidden, {area}, {"landuse", {"military"}}},
        {closed, Kind::forbidden, {area}, {"military"}},
        {water, Kind::water, {area}, {"natural", {"water"}}},               // [Tag:natural=water]
        {water, Kind::water, {area}, {"waterway", {"riverbank", "dock"}}},  // [K:waterway]
        {water, Kind::water, {area}, {"landuse", {"reservoir", "basin"}}},  // [K:landuse]
        {water, Kind::water, {area}, {"leisure", {"swimming_pool"}}},       // [Tag:leisure=swimming_pool]
        {water, Kind::water, {line}, {"waterway", {"river"}}, 12},          // [K:waterway]; median of 84 areas: 11
        {water, Kind::water, {line}, {"waterway", {"canal"}}, 12},          // [K:waterway]; median of 9 areas: 13
        {water, Kind::cliff, {line}, {"natural", {"cliff"}}, 1},            // [Tag:natural=cliff]
        {water, Kind::cliff, {line, area}, {"barrier", {"retaining_wall"}}, 0.5},  // [Tag:barrier=retaining_wall]
        {water, Kind::cliff, {line, area}, {"barrier", {"city_wall"}}, 2},         // [Tag:barrier=city_wall]
        {water, Kind::cliff, {line, area}, {"barrier", {"ditch"}}, 1},             // [Tag:barrier=ditch]
        // [K:railway]: tracks in use; trams run in streets. The width of a track with its ballast is a choice.
        {forbidden,
         Kind::forbidden,
         {line},
         {"railway", {"rail", "light_rail", "narrow_gauge", "subway", "funicular", "preserved"}},
         4},
        {forbidden, Kind::forbidden, {area}, {"access", {"no", "private"}}},  // [K:access]
        // [K:barrier]: what is long and stands up.
        {barrier,
         Kind::barrier,
         {line, area},
         {"barrier",
          {"wall", "fence", "hedge", "guard_rail", "jersey_barrier", "cable_barrier", "chain", "handrail",
           "avalanche_protection", "block", "yes"}}},
    };
    return rows;
}

// [K:barrier]: nodes where a barrier lets pass. A stile is for legs.
bool opens_barriers(const TagSet& tags, Profile profile) {
    static const TagFilter gates{
        "barrier",
        {"gate", "lift_gate", "swing_gate", "sliding_gate", "hampshire_gate", "bump_gate", "kissing_gate", "entrance",
         "cattle_grid", "toll_booth", "border_control", "sally_port", "bollard", "cycle_barrier"}};
    return tags.matches(gates) || (profile == Profile::walker && tags.is("barrier", "stile"));
}

bool says_one_of(const TagSet& tags, std::string_view key, std::initializer_list<std::string_view> values) {
    return std::any_of(values.begin(), values.end(), [&](std::string_view value) { return tags.is(key, value); });
}

bool is_closed(const TagSet& tags, std::string_view key) {
    return says_one_of(tags, key, {"no", "private"});
}

// [K:access]: the vehicle's own key speaks before the general one.
bool may_enter(const TagSet& tags, Profile profile) {
    for (const std::string_view mode : vehicle(profile).modes) {
        if (tags.find(mode) != nullptr) return !is_closed(tags, mode);
    }
    return !is_closed(tags, "access");
}

bool in_passage(const TagSet& tags) {
    return says_one_of(tags, "tunnel", {"building_passage", "covered", "arcade", "colonnade", "avalanche_protector"});
}

// [K:tunnel], [K:layer], [K:location]
bool in_tunnel(const TagSet& tags) {
    return tags.says("tunnel") && !in_passage(tags);
}

bool is_below(const TagSet& tags) {
    return tags.number("layer").value_or(0) < 0;
}

// In a house, on its roof or under the ground.
bool is_elsewhere(const TagSet& tags) {
    return tags.says("indoor") || says_one_of(tags, "parking", {"underground", "rooftop", "multi-storey"}) ||
           says_one_of(tags, "location", {"underground", "indoor", "roof", "rooftop"});
}

bool is_ground(const TagSet& tags) {
    constexpr std::array keys{"amenity", "historic", "landuse", "leisure", "man_made", "natural", "power", "tourism"};
    return std::any_of(keys.begin(), keys.end(), [&](const char* key) { return tags.says(key); });
}

double width_of(const TagSet& tags, double usual, double widest) {
    const double width = tags.number("width").value_or(0);
    return width > 0 && width <= widest ? width : usual;
}

double way_width(const TagSet& tags, double usual) {
    const double lanes = tags.number("lanes").value_or(0);
    return width_of(tags, lanes >= 1 ? lanes * lane_width : usual, widest_way);
}

Right right_of(const WayClass& way, Profile profile) {
    return profile == Profile::truck ? way.truck : profile == Profile::walker ? way.walker : way.rover;
}

void add_way(const TagSet& tags, const WayClass& way, Shape shape, Profile profile, std::vector<GroundUse>& uses) {
    if (is_elsewhere(tags)) return;
    const double own = vehicle(profile).width;
    const double width = std::max(way_width(tags, way.width), own);
    const Right right = right_of(way, profile);
    if (right != Right::drives || !may_enter(tags, profile)) {
        const bool closed = right == Right::must_not || is_closed(tags, "access");
        if (closed && shape == Shape::line && !in_tunnel(tags) && !in_passage(tags)) {
            uses.push_back({GroundLayer::forbidden, Kind::forbidden, width});
        }
        return;
    }
    const bool below = is_below(tags) && !in_passage(tags);
    const bool over = tags.says("bridge") || tags.says("ford") || tags.says("embankment");
    const bool bridge = tags.says("bridge") && !below;
    if (over && !below) uses.push_back({.layer = GroundLayer::way_over, .width = width, .bridge = bridge});
    // Without the line in its middle an area opens what it lies over, but no fence or house that stands on it.
    if (shape != Shape::line) return;
    uses.push_back({.layer = in_tunnel(tags) || below ? GroundLayer::underpass : GroundLayer::way,
                    .width = own,
                    .bridge = bridge});
}

void add_blocked(const TagSet& tags, Shape shape, std::vector<GroundUse>& uses) {
    if (in_tunnel(tags) || is_elsewhere(tags)) return;
    const bool roofed = tags.says("covered");
    for (const Blocking& row : grounds()) {
        const bool fits = std::find(row.shapes.begin(), row.shapes.end(), shape) != row.shapes.end();
        const std::string* value = tags.find(row.filter.key);
        // `access=no` is a value here like any other.
        if (!fits || value == nullptr ||
            !(row.filter.accepts(*value) || (row.filter.key == "access" && *value == "no"))) {
            continue;
        }
        if (row.kind == Kind::water && roofed) return;
        if (row.filter.key == "access" && (tags.says("building") || tags.says("boundary") || is_below(tags))) return;
        if (row.layer == GroundLayer::barrier && (tags.says("building") || is_below(tags))) return;
        // A pitch with a fence is fenced in; an area that is nothing but a hedge is all hedge.
        const bool fenced = row.filter.key == "barrier" && shape == Shape::area && is_ground(tags);
        const bool river = row.kind == Kind::water && shape == Shape::line;
        uses.push_back({row.layer, row.kind, width_of(tags, row.width, widest_river), fenced,
                        river && tags.find("width") == nullptr});
        return;
    }
}

}  // namespace

std::vector<GroundUse> ground_uses(const TagSet& tags, Shape shape, Profile profile) {
    std::vector<GroundUse> uses;
    if (profile == Profile::paper) return uses;
    if (shape == Shape::point) {
        const bool locked = is_closed(tags, "access") || tags.is("locked", "yes");
        if (opens_barriers(tags, profile) && !locked) {
            uses.push_back({.layer = GroundLayer::gate, .width = vehicle(profile).width});
        }
        return uses;
    }
    const std::string* highway = tags.find("highway");
    const auto* const way = std::find_if(way_classes.begin(), way_classes.end(), [&](const WayClass& one) {
        return highway != nullptr && one.highway == *highway;
    });
    if (way != way_classes.end()) {
        add_way(tags, *way, shape, profile, uses);
    } else if (tags.is("man_made", "pier") && may_enter(tags, profile)) {
        uses.push_back({.layer = GroundLayer::way_over, .width = way_width(tags, pier_width)});
        if (shape == Shape::line) uses.push_back({.layer = GroundLayer::way, .width = vehicle(profile).width});
    }
    if (way == way_classes.end() || shape == Shape::line) add_blocked(tags, shape, uses);
    return uses;
}

// [K:building]: a roof on posts, a carport and a bridge let pass below.
bool stands_in_the_way(const TagSet& building) {
    return building.says("building") && !says_one_of(building, "building", {"roof", "carport", "canopy", "bridge"}) &&
           !says_one_of(building, "location", {"underground"}) && !is_below(building);
}

const Protection& protection(Profile profile) {
    static const Protection nothing{};
    static const Protection people{{{"amenity", {"hospital", "school", "kindergarten", "place_of_worship"}},
                                    {"landuse", {"religious"}},
                                    {"building",
                                     {"hospital", "school", "kindergarten", "church", "chapel", "cathedral", "mosque",
                                      "synagogue", "temple", "shrine", "religious"}},
                                    {"historic"},
                                    {"heritage"}},
                                   "hospitals, schools, places of worship, heritage"};
    return profile == Profile::paper ? nothing : people;
}

// [K:historic]: points are also plaques, crosses and stones in or on walls of houses that are no heritage for that,
// and the names of whole districts.
bool holds_around_point(std::string_view key, const TagSet& point) {
    if (key != "historic" && key != "heritage") return true;
    return !says_one_of(point, "historic",
                        {"memorial", "monument", "statue", "tomb", "stone", "milestone", "boundary_stone",
                         "wayside_cross", "wayside_shrine", "district"});
}

const std::vector<TagFilter>& ground_keys(std::optional<Shape> shape) {
    static const std::vector<TagFilter> of_points{{"barrier"}};
    static const std::vector<TagFilter> keys{{"natural"},  {"waterway"}, {"landuse"}, {"leisure"}, {"barrier"},
                                             {"military"}, {"railway"},  {"highway"}, {"access"},  {"man_made"}};
    return shape == Shape::point ? of_points : keys;
}

double vehicle_width(Profile profile) {
    return vehicle(profile).width;
}

}  // namespace waybreaker::city
