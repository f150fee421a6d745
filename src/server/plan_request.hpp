// What a client asks to be planned, as JSON: a mission file (io/mission_json.hpp), or in short
//
//     {"mission": {"start": [256, 434], "goal": [118, 55], "air_speed": 2},
//      "options": {"removals": 2, "select": "exact", "protect": [17]}}
//
// "mission" can be a mission file as well, which "options" override. Options are named as in plan files (contract,
// section 4) and as those of `waybreaker plan`; what is left out has the same defaults.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/map_file.hpp"
#include "io/mission_json.hpp"
#include "waybreaker/method.hpp"

namespace waybreaker::server {

// Largest request that is parsed.
inline constexpr std::size_t max_request_bytes = std::size_t{1} << 20;

// Who goes where: a mission file's agents, or what the short form says.
struct MissionRequest {
    std::vector<Agent> agents;  // empty: as below
    std::optional<Cell> start;  // else as the map's file says
    std::optional<Cell> goal;
    std::optional<Cell> air_start;  // else the ground agent's
    std::optional<Cell> air_goal;
    double ground_speed = 1;
    double air_speed = 1;
};

struct OptionsRequest {
    Rules rules;
    Method method;
    Limits limits;
    std::optional<double> radius;  // of the ground agent, else as the mission says
    std::optional<Corners> corners;
    bool planner_given = false;
    struct Weight {
        ObstacleId obstacle;
        double weight = 1;
    };
    std::vector<Weight> weights;    // of some obstacles; of the others as the map says
    bool weights_of_cells = false;  // each its number of cells
    bool budget_given = false;      // without removals it stands in place of a count
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
    std::vector<Variant> variants;  // options those of the request unless a variant says otherwise
    bool timing_fields = true;      // false: no measured seconds in the answer
};

// Throws InputError: "request: ", where in it, what is wrong. `name` is how it is called.
PlanRequest parse_plan_request(std::string_view bytes, const std::string& name = "request");

// Both put on a map; throws InputError if they do not fit it.
io::MissionDocument document_of(const MissionRequest& mission, const OptionsRequest& options, const io::MapFile& map);
// What obstacles weigh, by id, if the request says that.
std::optional<std::vector<double>> weights_of(const OptionsRequest& request, const Map& map);

}  // namespace waybreaker::server
