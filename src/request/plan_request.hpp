// A planning request as JSON: a mission file (io/mission_json.hpp), or the short form
//
//     {"mission": {"start": [256, 434], "goal": [118, 55], "air_speed": 2},
//      "options": {"removals": 2, "select": "exact", "protect": [17]}}
//
// "mission" can also be a mission file, which "options" override. Options have the names they have in plan files
// (contract, section 4), and the defaults of `waybreaker plan`.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/map_file.hpp"
#include "io/mission_document.hpp"

namespace waybreaker::request {

// Largest request that is parsed.
inline constexpr std::size_t max_request_bytes = std::size_t{1} << 20;

// A mission in short.
struct ShortMission {
    std::optional<Cell> start;  // default: as in the map file
    std::optional<Cell> goal;
    std::optional<Cell> air_start;  // default: the ground agent's
    std::optional<Cell> air_goal;
    double ground_speed = 1;
    double air_speed = 1;
};

struct OptionsRequest {
    io::MissionDocument asked;     // without agents where the mission is one in short
    std::optional<double> radius;  // of the ground agent; default: as in the mission
    std::optional<Corners> corners;
    bool planner_given = false;
    struct Weight {
        ObstacleId obstacle;
        double weight = 1;
    };
    std::vector<Weight> weights;    // of some obstacles; others keep the map's
    bool weights_of_cells = false;  // weight = number of cells
    bool budget_given = false;      // replaces the number of removals unless that is given too
    bool removals_given = false;
};

// One of several plans to compare.
struct Variant {
    std::string name;
    OptionsRequest options;
};

struct PlanRequest {
    ShortMission mission;
    OptionsRequest options;
    std::vector<Variant> variants;  // their options default to those of the request
    bool timing_fields = true;      // false: no measured seconds in the response
};

// Throws InputError that says where and what is wrong; `name` is what errors call the input.
PlanRequest parse_plan_request(std::string_view bytes, const std::string& name = "request");

// A live mission: a request as above, or a mission file, which names its map.
//
//     {"map": "berlin-mitte.tif", "mission": {"start": [256, 434], "goal": [118, 55]}, "reaction": 2}
struct LiveRequest {
    std::string map;
    PlanRequest plan;
    double reaction = 0;  // how long agents take to learn of a new plan, in units of time
};

LiveRequest parse_live_request(std::string_view bytes, const std::string& name = "request");

// A mission on its map.
struct MissionOnMap {
    io::MissionDocument asked;
    std::optional<Map> reweighted;  // the map to plan on, if the request says what obstacles weigh
};

// Throws InputError if the mission, or what obstacles weigh, does not fit the map, or each other.
MissionOnMap on_map(const ShortMission& mission, const OptionsRequest& options, const io::MapFile& map);

}  // namespace waybreaker::request
