// What a client asks to be planned, as JSON:
//
//     {"mission": {"start": [256, 434], "goal": [118, 55], "air_speed": 2},
//      "options": {"removals": 2, "select": "exact", "protect": [17]}}
//
// Members are named as in plan files (contract, section 4) and as the options of `waybreaker plan`; what is left out
// has the same defaults.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/map_file.hpp"
#include "waybreaker/mission.hpp"

namespace waybreaker::server {

// Largest request that is parsed.
inline constexpr std::size_t max_request_bytes = std::size_t{1} << 20;

struct MissionRequest {
    std::optional<Cell> start;  // else as the map's file says
    std::optional<Cell> goal;
    std::optional<Cell> air_start;  // else the ground agent's
    std::optional<Cell> air_goal;
    double ground_speed = 1;
    double air_speed = 1;
};

struct OptionsRequest {
    MissionOptions options;
    bool planner_given = false;
    struct Weight {
        ObstacleId obstacle;
        double weight = 1;
    };
    std::vector<Weight> weights;    // of some obstacles; of the others as the map says
    bool weights_of_cells = false;  // each its number of cells
    bool budget_alone = false;      // stands in place of a count
};

struct Method {
    std::string name;
    OptionsRequest options;
};

struct PlanRequest {
    MissionRequest mission;
    OptionsRequest options;
    std::vector<Method> methods;  // to compare, options those of the request unless a method says otherwise
    bool timing_fields = true;    // false: no measured seconds in the answer
};

// Throws InputError: "request: ", where in it, what is wrong. `name` is how it is called.
PlanRequest parse_plan_request(std::string_view bytes, const std::string& name = "request");

// Both put on a map. Throw InputError if they do not fit it.
Mission mission_of(const MissionRequest& request, const io::MapFile& map);
MissionOptions options_of(const OptionsRequest& request, const io::MapFile& map);

}  // namespace waybreaker::server
