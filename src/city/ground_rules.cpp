#include "city/ground_rules.hpp"

#include "city/ground_levels.hpp"
#include "city/rule_tables.hpp"
#include "city/vehicle_rules.hpp"

namespace waybreaker::city {

using Shape = site::Background::Shape;

std::vector<GroundUse> ground_uses(const TagSet& tags, Shape shape, Profile profile) {
    std::vector<GroundUse> uses;
    if (profile == Profile::paper) return uses;
    if (shape == Shape::point) {
        add_point(tags, profile, uses);
        return uses;
    }
    const bool way = add_way(tags, shape, profile, uses);
    if (!way || shape == Shape::line) add_blocked(tags, shape, profile, uses);
    return uses;
}

// [Key:building]: a roof on posts, a carport and a bridge let pass below; a garage below the ground bears what is
// above.
bool stands_in_the_way(const TagSet& building) {
    return building.says("building") && !says_one_of(building, "building", {"roof", "carport", "canopy", "bridge"}) &&
           !says_one_of(building, "location", {"underground"}) && !building.is("parking", "underground") &&
           !is_below(building);
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

// [Key:historic]: points are also plaques, crosses and stones in or on walls of houses that are no heritage for that,
// and the names of whole districts.
bool holds_around_point(std::string_view key, const TagSet& point) {
    if (key != "historic" && key != "heritage") return true;
    return !says_one_of(point, "historic",
                        {"memorial", "monument", "statue", "tomb", "stone", "milestone", "boundary_stone",
                         "wayside_cross", "wayside_shrine", "district"});
}

const std::vector<TagFilter>& ground_keys(std::optional<Shape> shape) {
    static const std::vector<TagFilter> of_points{{"barrier"}};
    static const std::vector<TagFilter> keys{{"natural"},  {"waterway"}, {"landuse"}, {"leisure"},  {"barrier"},
                                             {"military"}, {"railway"},  {"highway"}, {"access"},   {"man_made"},
                                             {"amenity"},  {"aeroway"},  {"power"},   {"historic"}, {"area:highway"}};
    return shape == Shape::point ? of_points : keys;
}

}  // namespace waybreaker::city
