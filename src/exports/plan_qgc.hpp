// The flight of each aircraft as a .plan file of QGroundControl, whose mission autopilots of the MAVLink protocol fly:
// take-off, speed, a way point at each stop, the command of the breach and a stay for as long as it takes, landing.
//
// What the aircraft keeps out of is an exclusion polygon of the fence each.
//
// Heights are above the place of take-off. The plan's times know neither climb nor descent.
#pragma once

#include <string>
#include <vector>

#include "exports/mav_command.hpp"
#include "exports/placed_plan.hpp"
#include "io/output_file.hpp"

namespace waybreaker::exports {

// One file for each flight: `path` itself for one aircraft; for several its name with "-" and the aircraft's id
// before the ending. One that recharges has a file for each flight from landing to landing, "-1", "-2" before the
// ending. Throws InputError if the map does not say where it lies on earth, no altitude is given, the plan
// has no aircraft or was revised under way, one begins in a hole of a zone, or one name would stand for several files.
std::vector<io::OutputFile> plan_qgc(const PlacedPlan& placed, const std::string& path, const MavAction& breach = {});

}  // namespace waybreaker::exports
