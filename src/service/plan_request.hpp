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
#include "io/mission_json.hpp"
#include "waybreaker/method.hpp"

namespace waybreaker::service {

// Largest request that is parsed.
inline constexpr std::size_t max_request_bytes = std::size_t{1} << 20;

// The agents of a mission file, or the short form.
struct MissionRequest {
    std::vector<Agent> agents;  // empty: the short form below
    std::optional<Cell> start;  // default: as in the map file
    std::optional<Cell> goal;
    std::optional<Cell> air_start;  // default: the ground agent's
    std::optional<Cell> air_goal;
    double ground_speed = 1;
    double air_speed = 1;
};

struct OptionsRequest {
    Rules rules;
    Method method;
    Limits limits;
    std::optional<double> radius;  // of the ground agent; default: as in the mission
    std::optional<Corners> corners;
    bool planner_given = false;
    struct Weight {
        ObstacleId obstacle;
        double weight = 1;
    };
    std::vector<Weight> weights;                // of some obstacles; others keep the map's
    bool weights_of_cells = false;              // weight = number of cells
    bool area_budget = false;                   // weight = area, in square metres
    bool in_seconds = false;                    // a unit of time is a second
    std::vector<site::TagFilter> protect_tags;  // beside rules.protect
    bool budget_given = false;                  // replaces the number of removals unless that is given too
    bool removals_given = false;
};

// One of several plans to compare.
struct Variant {
    std::string name;
    OptionsRequest options;
};

struct PlanRequest {
    MissionRequest mission;
    OptionsRequest options;
    std::vector<Variant> variants;  // their options default to those of the request
    bool timing_fields = true;      // false: no measured seconds in the response
};

// Throws InputError that says where and what is wrong; `name` is what errors call the input.
PlanRequest parse_plan_request(std::string_view bytes, const std::string& name = "request");

// The mission on a map. Throws InputError if it does not fit the map.
io::MissionDocument document_of(const MissionRequest& mission, const OptionsRequest& options, const io::MapFile& map);
// Weights of obstacles by id, if the request sets any. Throws InputError if they do not fit the map, or its budget.
std::optional<std::vector<double>> weights_of(const OptionsRequest& request, const io::MapFile& file);

}  // namespace waybreaker::service
