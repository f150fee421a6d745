// Shortcuts: which obstacles to open so that a ground path can go straight more often. A guess, quickly made.
#pragma once

#include <span>
#include <vector>

#include "select/task.hpp"

namespace waybreaker {

// At most as many obstacles as the options allow to be removed: what stands in the way of those straight lines between
// places of the path that save most together. An obstacle in the way of two lines is counted twice. Some milliseconds:
// of a long path only so many places are looked at.
std::vector<ObstacleId> chosen_by_shortcuts(const Task& task, std::span<const Point> path);

}  // namespace waybreaker
