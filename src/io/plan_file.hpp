// Plan files, read back: what plan_json.hpp writes (contract, section 4), as far as a plan can be judged by it.
#pragma once

#include <string>
#include <string_view>

#include "io/json_field.hpp"
#include "io/map_file.hpp"
#include "io/mission_document.hpp"
#include "waybreaker/plan.hpp"

namespace waybreaker::io {

struct PlanFile {
    Plan plan;  // without seconds of its parts
    // What was asked and how it was planned. Files of the first version do not say all of it: the rest has defaults.
    MissionDocument asked;
    struct Weight {
        ObstacleId obstacle;
        double weight = 1;
    };
    std::vector<Weight> weights = {};  // of removed obstacles, where the file says them
    // What it says of areas and sums, to be judged: each of `removed`, all of them, and each step of the front.
    std::vector<std::optional<double>> areas = {};
    struct Demolition {
        std::optional<std::uint64_t> removals = {};
        std::optional<std::uint64_t> cells = {};
        std::optional<std::uint64_t> structures = {};
        std::optional<double> area_m2 = {};
        std::optional<double> least_area_m2 = {};
    } demolition = {};
    struct Step {
        std::vector<ObstacleId> removed;
        double area_m2 = 0;
    };
    std::vector<Step> front = {};  // those that say an area
    // Of each of the agents, as site::Surface has it, in cells.
    struct Surface {
        std::optional<double> ways = {};
        std::optional<double> off_ways = {};
        std::optional<double> unknown = {};
        std::optional<double> near_water = {};
    };
    std::vector<Surface> surfaces = {};
    bool states_orders = false;
    Connectivity connectivity = Connectivity::four;
    ImageReading image;
    // The map it was made for.
    int width = 0;
    int height = 0;
    double cell_size = 1;
    std::string digest;
    std::string supersedes;  // of a revision: the digest of the file of the plan before
};

// The map that the plan was made on: what was found by then laid over it.
MapFile known_map(MapFile file, const Plan& plan);

// Larger files are refused; a path of half a million points fits.
inline constexpr std::size_t max_plan_bytes = std::size_t{1} << 24;
inline constexpr int max_plan_depth = 13;

// Throws InputError: the file's name, where in it, what is wrong. `name` is how the input is called in errors.
PlanFile parse_plan(std::string_view bytes, const std::string& name);
PlanFile read_plan(const JsonField& root);
PlanFile read_plan_file(const std::string& path);

}  // namespace waybreaker::io
