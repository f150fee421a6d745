// Plans as GPX 1.1: a track with times for each agent, a way point for each breach.
//
//     <wpt lat="52.522" lon="13.38"><time>2026-05-01T08:00:53.140Z</time><name>obstacle 129</name>...</wpt>
//     <trk><name>ground</name><type>ground</type><trkseg><trkpt lat="52.521" lon="13.381"><time>...</time></trkpt>...
//
// A track has a point wherever its agent turns, begins to wait or goes on; between them it moves straight and evenly. A
// way point's time is when the obstacle is gone.
#pragma once

#include <string>

#include "exports/placed_plan.hpp"

namespace waybreaker::exports {

// Throws InputError if the map does not say where it lies on earth.
std::string plan_gpx(const PlacedPlan& placed);

}  // namespace waybreaker::exports
