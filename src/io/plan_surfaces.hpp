// What the vehicles of a plan drive over.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/map_file.hpp"
#include "site/surface.hpp"
#include "waybreaker/mission.hpp"
#include "waybreaker/plan.hpp"

namespace waybreaker::io {

// Of each agent of the plan; empty for aircraft, and for all where the map knows no ways or no metres.
std::vector<std::optional<site::Surface>> plan_surfaces(const Plan& plan, const MapFile& map);

// "ground agent: 1180 m on ways, 64 m off ways", of all vehicles together; empty where the map does not know.
std::string surface_line(const Plan& plan, const Mission& mission, const MapFile& map);

}  // namespace waybreaker::io
