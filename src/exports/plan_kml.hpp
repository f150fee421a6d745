// Plans as KML 2.2 with Google's extension gx:Track, which Google Earth plays in time.
//
// Folders: "agents", a track each; "breaches", a point for as long as the agent stays there; "obstacles", the
// outline of each obstacle that is opened, once until then and once from then on; "zones", where there are any.
#pragma once

#include <string>

#include "exports/placed_plan.hpp"

namespace waybreaker::exports {

// Aircraft fly at their altitude above the ground; on it, as vehicles do, if it is not known. Throws InputError if the
// map does not say where it lies on earth.
std::string plan_kml(const PlacedPlan& placed);

}  // namespace waybreaker::exports
