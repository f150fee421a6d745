// Bridges are entered at their ends: what bars their sides.
#pragma once

#include <vector>

#include "city/ground.hpp"

namespace waybreaker::city {

// How far, in metres, cells can lie from the line of a way, by their centres, that it opens for a vehicle of that
// width.
double opened_reach(double vehicle, double cell);

// Makes strips of the lines of the layer `bridge_side` among the pieces, a cell wider to either side than what the
// bridge opens, which is painted over them. They end where the bridge does, but not where another goes on.
void widen_bridge_sides(std::vector<GroundPiece>& pieces, double cell);

}  // namespace waybreaker::city
