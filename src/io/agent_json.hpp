// Agents as missions and states have them: one JSON object each.
#pragma once

#include <string>

#include "io/json_field.hpp"
#include "waybreaker/mission.hpp"

namespace waybreaker::io {

inline constexpr double most_radius = 32;  // cells

// Throw InputError that says where in the document what is wrong. Whether the agent fits a map is not asked.
double read_positive(const JsonField& field);
double read_between(const JsonField& field, double least, double most);
std::string read_agent_id(const JsonField& field);
Waypoint read_waypoint(const JsonField& field);
void read_body(const JsonField& field, Body& body);
Agent read_agent_of_mission(const JsonField& field);

// Reads back as what was written. REQUIRES: an agent of a valid mission, whose numbers are finite.
nlohmann::ordered_json mission_agent_json(const Agent& agent);

}  // namespace waybreaker::io
