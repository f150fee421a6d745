// The mission file, "waybreaker-mission/1" (docs/contract.md, section 6): what is asked, how it is planned, how long
// that may take. Plan files hold a copy of it, and the service takes it as a request.
//
//     {"format": "waybreaker-mission/1",
//      "agents": [{"id": "ground", "kind": "ground", "start": [56, 72], "goal": [279, 217], "speed": 1, "radius": 0.5},
//                 {"id": "air", "kind": "air", "start": [56, 72], "goal": [279, 217], "speed": 2}],
//      "rules": {"removals": 2, "breach_time": 5},
//      "method": {"select": "exact"},
//      "limits": {"seconds": 10}}
//
// Only "format" and "agents" must be there; the rest has the library's defaults.
#pragma once

#include <string>
#include <string_view>

#include "io/agent_json.hpp"
#include "io/json_field.hpp"
#include "io/mission_document.hpp"

namespace waybreaker::io {

// Larger files are refused.
inline constexpr std::size_t max_mission_bytes = std::size_t{1} << 20;
inline constexpr int max_mission_depth = 12;

// Throw InputError: the file's name, where in it, what is wrong. Whether the mission fits a map is not asked. `name` is
// how the input is called in errors. `limits` hold where the document states none; "seconds": null is no limit.
MissionDocument parse_mission(std::string_view bytes, const std::string& name, const Limits& limits = {});
MissionDocument read_mission_file(const std::string& path, const Limits& limits = {});
MissionDocument read_mission(const JsonField& document, const Limits& limits = {});

// The document, all its members there; reads back as what was written.
nlohmann::ordered_json mission_json(const MissionDocument& document);
// The same as text, indented, with a final newline.
std::string mission_text(const MissionDocument& document);

// JSON for people: a line for each member of the document and for each object of a list, the rest on one line.
std::string pretty(const nlohmann::ordered_json& json);

// Parts that other documents have as well.
Cell read_cell(const JsonField& field);
nlohmann::ordered_json cell_json(Cell c);
// `least`: 0 where a wrong id is judged, not refused.
ObstacleId read_obstacle(const JsonField& field, std::uint32_t least = 1);
double read_not_negative(const JsonField& field);
double read_share(const JsonField& field);  // 0 to 1
// Members of `field` that are rules, under the names of Rules, over what is there; budget_m2 is a budget of square
// metres, and what is protected may be ids or tags.
void read_rules(const JsonField& field, MissionDocument& document);
// Members of `field` that say how the mission is planned.
void read_method(const JsonField& field, Method& method);
std::vector<TimedOpening> read_openings(const JsonField& list);

}  // namespace waybreaker::io
