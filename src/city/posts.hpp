// Barriers that stand as points in a way.
#pragma once

#include <vector>

#include "city/ground.hpp"

namespace waybreaker::city {

// Makes discs of the points of the layers `barrier` and `shut` among the pieces, as wide as the way that they stand in
// and what it opens; those that stand in none are left out.
void widen_posts(std::vector<GroundPiece>& pieces, double cell);

}  // namespace waybreaker::city
