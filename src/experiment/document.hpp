// Document: a mission as results files hold it, and as a line of a file of missions: "waybreaker-mission/1" on one
// line.
#pragma once

#include <string>

#include "waybreaker/mission.hpp"

namespace waybreaker::experiment {

// Agents and rules; how it is planned and for how long, the experiment says. `map`: the map's file, if it is named.
std::string document_of(const Mission& mission, const std::string& map = "");

}  // namespace waybreaker::experiment
