// The options of `waybreaker plan`, and the mission they describe together with a map file.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "commands.hpp"
#include "io/map_file.hpp"
#include "io/mission_json.hpp"
#include "plan_exports.hpp"
#include "waybreaker/method.hpp"

namespace waybreaker::apps {

inline constexpr double largest_radius = 32;

// As given on the command line. What is optional can come from --paper or from the map file.
struct PlanOptions {
    std::string map;
    std::string mission;  // a mission file
    std::string agents;   // a scenario file
    std::optional<int> count;
    std::optional<int> aircraft;
    std::optional<int> breaches;  // of each
    std::optional<Cell> start;
    std::optional<Cell> goal;
    std::optional<Cell> air_start;
    std::optional<Cell> air_goal;

    bool paper = false;
    std::optional<int> removals;
    bool removals_auto = false;  // as many as gain anything
    std::optional<Selection> select;
    std::optional<double> budget;
    bool area_budget = false;  // it is one of square metres
    std::string weights;
    bool bound = false;
    bool explain = false;
    std::optional<double> time_limit;  // seconds, of the whole call
    std::optional<FlightRule> flight;
    std::optional<Timing> timing;
    std::optional<double> ground_speed;
    std::optional<double> air_speed;
    std::optional<double> breach_time;
    std::optional<double> breach_time_per_cell;
    std::vector<ObstacleId> protect;
    std::vector<ObstacleId> force;
    std::optional<Objective> objective;
    std::optional<double> separation;
    std::optional<AtGoal> at_goal;
    Connectivity connectivity = Connectivity::four;
    io::ImageReading image;

    std::optional<Planner> planner;
    std::optional<Heuristic> heuristic;
    std::optional<double> weight;
    std::optional<TieBreak> tie_break;
    std::optional<Corners> corners;
    std::optional<double> radius;
    std::optional<bool> diagonal;
    std::optional<std::uint64_t> expansion_limit;

    std::optional<double> cell_size;
    std::string json;
    std::string save_mission;
    std::string svg;
    std::string png;
    std::string html;
    std::string trace;
    PlanExports exports;
    bool no_timing = false;
};

void add_plan_options(CLI::App& command, PlanOptions& options);

// Throws InputError, naming the options, if they contradict each other.
void validate(const PlanOptions& options);

// Whether an option applies only to a search with a heuristic.
bool needs_search(const PlanOptions& options);

// What obstacles weigh, by id, where the options or the mission's budget say so; throws InputError as io::read_weights
// and io::area_weights do.
std::optional<std::vector<double>> weights_of(const PlanOptions& options, const io::MissionDocument& mission,
                                              const io::MapFile& map);

// The options, else what the mission file says or --paper stands for, else what the map file says, else the defaults.
io::MissionDocument mission_of(const PlanOptions& options, const io::MapFile& map);

}  // namespace waybreaker::apps
