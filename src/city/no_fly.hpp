// No-fly zones of map data: what aircraft keep clear of.
#pragma once

#include <string>
#include <vector>

#include "city/city_import.hpp"
#include "waybreaker/zone.hpp"

namespace waybreaker::city {

inline constexpr double usual_clearance = 100;  // metres

// Aerodromes, heliports and helipads, prisons, and ground that the military uses or closes, each with what lies within
// `clearance` metres of it; of points, a circle. Corners are in cells of the window; what lies beyond it is cut off.
// Outlines are simplified by half a cell, by more where there would be more than most_zone_corners. In the source's
// order. Throws InputError if the source cannot be read, there is no such window, or there are too many.
std::vector<Zone> no_fly_zones(const std::string& source, const ImportOptions& window, double clearance);

}  // namespace waybreaker::city
