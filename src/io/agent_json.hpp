// Agents as missions and states have them: one JSON object each.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "io/json_field.hpp"
#include "site/tag_filter.hpp"
#include "waybreaker/mission.hpp"

namespace waybreaker::io {

inline constexpr std::size_t longest_id = 100;  // characters
inline constexpr double most_radius = 32;       // cells

// Throw InputError that says where in the document what is wrong. Whether the agent fits a map is not asked.
double read_positive(const JsonField& field);
double read_between(const JsonField& field, double least, double most);
std::string read_agent_id(const JsonField& field);
Waypoint read_waypoint(const JsonField& field);
void read_body(const JsonField& field, Body& body);
// `tags`, where given, takes those of what it can breach, which the map has to know.
Agent read_agent_of_mission(const JsonField& field, std::vector<site::TagFilter>* tags = nullptr);
// Ids of obstacles go to `ids`, tags such as "amenity=hospital" to `tags`.
void read_obstacles(const JsonField& list, std::vector<ObstacleId>& ids, std::vector<site::TagFilter>& tags);

// Reads back as what was written. REQUIRES: an agent of a valid mission, whose numbers are finite.
nlohmann::ordered_json mission_agent_json(const Agent& agent, std::span<const site::TagFilter> tags = {});

}  // namespace waybreaker::io
