// Lines and areas that bar the way.
#include <algorithm>
#include <array>

#include "city/ground_levels.hpp"
#include "city/measures.hpp"
#include "city/rule_tables.hpp"
#include "city/vehicle_rules.hpp"

namespace waybreaker::city {
namespace {

using Kind = site::ObstacleKind;
using Shape = site::Background::Shape;

constexpr double widest_river = 500;  // above, `width` is in other units

// Whom a row bars.
enum class Whom { all, wheels, trucks };

// Features of these shapes with that tag block.
struct Blocking {
    GroundLayer layer;
    Kind kind;
    std::vector<Shape> shapes;
    TagFilter filter;
    double width = 0;  // metres, where a line does not say it; every strip has at least a cell
    Whom whom = Whom::all;
    double least_width = 0;  // only lines whose `width` says at least that
};

// The first row that bars applies.
const std::vector<Blocking>& blockings() {
    constexpr Shape area = Shape::area;
    constexpr Shape line = Shape::line;
    using enum GroundLayer;
    static const std::vector<Blocking> table{
        // [Key:military], [Tag:landuse=military], [Tag:amenity=prison]
        {closed, Kind::forbidden, {area}, {"landuse", {"military"}}},
        {closed, Kind::forbidden, {area}, {"military"}},
        {closed, Kind::forbidden, {area}, {"amenity", {"prison"}}},
        {water, Kind::water, {area}, {"natural", {"water"}}},               // [Tag:natural=water]
        {water, Kind::water, {area}, {"waterway", {"riverbank", "dock"}}},  // [Key:waterway]
        // [Tag:landuse=reservoir], [Tag:landuse=basin], [Tag:landuse=salt_pond], [Tag:landuse=aquaculture]
        {water, Kind::water, {area}, {"landuse", {"reservoir", "basin", "salt_pond", "aquaculture"}}},
        {water, Kind::water, {area}, {"leisure", {"swimming_pool"}}},  // [Tag:leisure=swimming_pool]
        {water, Kind::water, {area}, {"natural", {"mud"}}},            // [Tag:natural=mud]: one sinks
        {water, Kind::water, {area}, {"wetland", {"tidalflat"}}},   // [Tag:wetland=tidalflat]: under water twice a day
        {water, Kind::water, {line}, {"waterway", {"river"}}, 12},  // [Key:waterway]; median of 84 areas: 11
        {water, Kind::water, {line}, {"waterway", {"canal"}}, 12},  // [Key:waterway]; median of 9 areas: 13
        // [Tag:waterway=stream], [Tag:waterway=drain], [Tag:waterway=ditch]: such as those of polders. The least width
        // is a choice: wheels of a robot or truck do not bridge it.
        {water, Kind::water, {line}, {"waterway", {"stream", "drain", "ditch"}}, 0, Whom::wheels, 2},
        {water, Kind::cliff, {line}, {"natural", {"cliff"}}, 1},                   // [Tag:natural=cliff]
        {water, Kind::cliff, {line, area}, {"barrier", {"retaining_wall"}}, 0.5},  // [Tag:barrier=retaining_wall]
        {water, Kind::cliff, {line, area}, {"barrier", {"city_wall"}}, 2},         // [Tag:barrier=city_wall]
        {water, Kind::cliff, {line, area}, {"historic", {"citywalls"}}, 2},        // [Tag:historic=citywalls]
        {water, Kind::cliff, {line, area}, {"barrier", {"ditch"}}, 1},             // [Tag:barrier=ditch]
        {forbidden, Kind::forbidden, {area}, {"natural", {"glacier"}}},            // [Tag:natural=glacier]: crevasses
        // [Tag:aeroway=runway], [Tag:aeroway=taxiway]: as wide as the Aerodrome Design Manual of ICAO has them for
        // aircraft such as the A320 (codes 4 and C).
        {forbidden, Kind::forbidden, {line, area}, {"aeroway", {"runway"}}, 45},
        {forbidden, Kind::forbidden, {line, area}, {"aeroway", {"taxiway"}}, 15},
        {forbidden, Kind::forbidden, {area}, {"power", {"substation"}}},  // [Tag:power=substation]
        // [Key:railway]: tracks in use; trams run in streets. The width of a track with its ballast is a choice.
        {forbidden,
         Kind::forbidden,
         {line},
         {"railway", {"rail", "light_rail", "narrow_gauge", "subway", "funicular", "preserved"}},
         4},
        {forbidden, Kind::forbidden, {line}, {"man_made", {"pipeline"}}, 1},  // [Tag:man_made=pipeline]; choice
        {forbidden, Kind::forbidden, {area}, {"access", {"no", "private"}}},  // [Key:access]
        // [Key:man_made]: what stands up and is often drawn without `building`.
        {barrier,
         Kind::building,
         {area},
         {"man_made",
          {"storage_tank", "silo", "bunker_silo", "gasometer", "tower", "water_tower", "communications_tower",
           "cooling_tower", "chimney", "kiln", "lighthouse", "windmill"}}},
        // [Key:barrier]: what is long and stands up.
        {barrier,
         Kind::barrier,
         {line, area},
         {"barrier",
          {"wall", "fence", "hedge", "guard_rail", "jersey_barrier", "cable_barrier", "chain", "rope", "handrail",
           "avalanche_protection", "block", "yes"}}},
        // [Tag:barrier=log], [Tag:barrier=debris]: legs step over them.
        {barrier, Kind::barrier, {line, area}, {"barrier", {"log", "debris"}}, 0, Whom::wheels},
        // [Tag:barrier=bollard], [Tag:barrier=tank_trap], [Tag:barrier=planter]: with gaps that a truck does not fit.
        {barrier, Kind::barrier, {line, area}, {"barrier", {"bollard", "tank_trap", "planter"}}, 0, Whom::trucks},
    };
    return table;
}

bool is_ground(const TagSet& tags) {
    constexpr std::array keys{"amenity", "historic", "landuse", "leisure", "man_made", "natural", "power", "tourism"};
    return std::any_of(keys.begin(), keys.end(), [&](const char* key) { return tags.says(key); });
}

bool concerns(const Blocking& row, Profile profile) {
    return row.whom == Whom::all || (row.whom == Whom::wheels ? vehicle(profile).wheels : profile == Profile::truck);
}

// What the value of the filter's key does not say.
bool applies(const Blocking& row, const TagSet& tags, Profile profile) {
    const bool line_of_water = row.kind == Kind::water && row.least_width > 0;
    if (line_of_water && tags.number("width").value_or(0) < row.least_width) return false;
    if (row.kind == Kind::water && tags.says("covered")) return false;
    if (row.layer == GroundLayer::barrier && (tags.says("building") || is_below(tags))) return false;
    // Small ones are houses, or stand in them.
    if (row.filter.key == "power") return !tags.says("building");
    // A wall that says so is a barrier, and protected for being historic.
    if (row.filter.key == "historic") return !tags.says("barrier");
    if (row.filter.key == "access") return !tags.says("building") && !tags.says("boundary") && !is_below(tags);
    // Most pipelines lie in the ground, and those on posts let pass below.
    if (tags.is("man_made", "pipeline")) return says_one_of(tags, "location", {"overground", "surface"});
    // Legs climb what is no higher than a step or two.
    constexpr double climbed = 0.5;
    const std::string* const height = tags.find("height");
    const bool low = height != nullptr && metres_of(*height).value_or(climbed + 1) <= climbed;
    return !(tags.is("barrier", "retaining_wall") && low && !vehicle(profile).wheels);
}

}  // namespace

void add_blocked(const TagSet& tags, Shape shape, Profile profile, std::vector<GroundUse>& uses) {
    if (in_tunnel(tags) || is_elsewhere(tags)) return;
    for (const Blocking& row : blockings()) {
        const bool fits = std::find(row.shapes.begin(), row.shapes.end(), shape) != row.shapes.end();
        const std::string* value = tags.find(row.filter.key);
        // `access=no` is a value here like any other.
        const bool tagged =
            value != nullptr && (row.filter.accepts(*value) || (row.filter.key == "access" && *value == "no"));
        if (!fits || !tagged || !concerns(row, profile) || !applies(row, tags, profile)) continue;
        // A pitch with a fence is fenced in; an area that is nothing but a hedge is all hedge.
        const bool fenced = row.filter.key == "barrier" && shape == Shape::area && is_ground(tags);
        const bool river = row.kind == Kind::water && shape == Shape::line;
        uses.push_back({row.layer, row.kind,
                        shape == Shape::line || fenced ? width_of(tags, row.width, widest_river) : 0, fenced,
                        river && tags.find("width") == nullptr});
        return;
    }
}

}  // namespace waybreaker::city
