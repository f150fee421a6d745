// The tables that ground_uses() asks, each for what a feature adds to its uses.
#pragma once

#include <vector>

#include "city/ground_rules.hpp"

namespace waybreaker::city {

// Of lines and areas that are ways, or ground as good as one. Whether it is a way.
bool add_way(const TagSet& tags, site::Background::Shape shape, Profile profile, std::vector<GroundUse>& uses);

// Of lines and areas that bar.
void add_blocked(const TagSet& tags, site::Background::Shape shape, Profile profile, std::vector<GroundUse>& uses);

// Of points.
void add_point(const TagSet& tags, Profile profile, std::vector<GroundUse>& uses);

// The number that `width` says, if a way or water can be that wide; else the usual one.
double width_of(const TagSet& tags, double usual, double widest);

}  // namespace waybreaker::city
