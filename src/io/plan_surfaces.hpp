// What the vehicles of a plan drive over.
#pragma once

#include <optional>
#include <vector>

#include "io/map_file.hpp"
#include "site/surface.hpp"
#include "waybreaker/plan.hpp"

namespace waybreaker::io {

// Of each agent of the plan; empty for aircraft, and for all where the map knows no ways or no metres.
std::vector<std::optional<site::Surface>> plan_surfaces(const Plan& plan, const MapFile& map);

}  // namespace waybreaker::io
