#include "city/ground_levels.hpp"

#include "city/vehicle_rules.hpp"

namespace waybreaker::city {

bool in_passage(const TagSet& tags) {
    return says_one_of(tags, "tunnel", {"building_passage", "covered", "arcade", "colonnade", "avalanche_protector"});
}

bool in_tunnel(const TagSet& tags) {
    return tags.says("tunnel") && !in_passage(tags);
}

bool is_below(const TagSet& tags) {
    return tags.number("layer").value_or(0) < 0;
}

bool is_elsewhere(const TagSet& tags) {
    return tags.says("indoor") || says_one_of(tags, "parking", {"underground", "rooftop", "multi-storey"}) ||
           says_one_of(tags, "location", {"underground", "indoor", "roof", "rooftop"});
}

bool on_bridge(const TagSet& tags) {
    return tags.says("bridge") && !says_one_of(tags, "bridge", {"boardwalk", "low_water_crossing"}) && !is_below(tags);
}

}  // namespace waybreaker::city
