// The paths of a plan as ROS knows them: YAML of nav_msgs/Path, one document for each agent, the ground agent's first.
//
// Positions are metres in the map's frame (`frame_id: map`; map_frame.hpp), the orientation is where the agent goes
// next. A stamp is when it is there, from 0 on: a unit of the plan's time counts as a second, so that a speed of 1 is
// one cell a second.
#pragma once

#include <string>

#include "io/map_file.hpp"
#include "waybreaker/plan.hpp"

namespace waybreaker::io {

std::string plan_ros_path(const Plan& plan, const MapFile& map);

}  // namespace waybreaker::io
