// The paths of a plan as ROS 2 knows them: a YAML document with a nav_msgs/msg/Path for each agent, by its id, the
// ground agent's first.
//
//     ground:
//       header: {stamp: {sec: 0, nanosec: 0}, frame_id: map}
//       poses:
//       - {header: {stamp: {sec: 0, nanosec: 0}, frame_id: map}, pose: {position: {...}, orientation: {...}}}
//
// Positions are metres in the map's frame (map_frame.hpp); the orientation is where the agent goes next. A stamp is
// when it is there, from 0 on: a unit of the plan's time counts as a second, so that a speed of 1 is one cell a second.
// A wait is two poses at one place, with different stamps.
#pragma once

#include <optional>
#include <string>

#include "io/map_file.hpp"
#include "waybreaker/plan.hpp"

namespace waybreaker::io {

// Poses lie at most `step` metres apart (empty: the side of a cell), one at each corner. Throws InputError if these are
// too many, or the plan takes longer than ROS can count.
std::string plan_ros_path(const Plan& plan, const MapFile& map, std::optional<double> step = {});

// The same cut in parts (path_parts.hpp), for controllers that ignore stamps: of each agent a list of paths, and with
// each the obstacles that must be open before it is driven.
//
//     ground:
//     - openings: [2]
//       header: {stamp: {sec: 27, nanosec: 100000000}, frame_id: map}
//       poses:
//       - ...
//
// The stamp of a part is when the agent sets out on it.
std::string plan_ros_parts(const Plan& plan, const MapFile& map, const Mission& mission,
                           std::optional<double> step = {});

}  // namespace waybreaker::io
