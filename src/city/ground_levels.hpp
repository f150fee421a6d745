// Whether a feature lies on the ground, above or below it: [Key:tunnel], [Key:bridge], [Key:layer], [Key:location].
#pragma once

#include "city/tag_set.hpp"

namespace waybreaker::city {

bool in_passage(const TagSet& tags);
bool in_tunnel(const TagSet& tags);
bool is_below(const TagSet& tags);

// In a house, on its roof or under the ground.
bool is_elsewhere(const TagSet& tags);

// A bridge that can be used. A boardwalk and a causeway that floods lie on the ground.
bool on_bridge(const TagSet& tags);

}  // namespace waybreaker::city
