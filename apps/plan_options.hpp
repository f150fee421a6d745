// The options of `waybreaker plan`, and the mission they describe together with a map file.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "commands.hpp"
#include "io/map_file.hpp"
#include "plan_exports.hpp"
#include "waybreaker/mission.hpp"

namespace waybreaker::apps {

// As given on the command line. What is optional can come from --paper or from the map file.
struct PlanOptions {
    std::string map;
    std::optional<Cell> start;
    std::optional<Cell> goal;
    std::optional<Cell> air_start;
    std::optional<Cell> air_goal;

    bool paper = false;
    std::optional<int> removals;
    bool removals_auto = false;  // as many as gain anything
    std::optional<Selection> select;
    std::optional<double> budget;
    std::string weights;
    bool bound = false;
    bool explain = false;
    double time_limit = 10;  // seconds, of the whole call
    std::optional<FlightRule> flight;
    std::optional<Timing> timing;
    double ground_speed = 1;
    double air_speed = 1;
    BreachTime breach_time;
    std::vector<ObstacleId> protect;
    std::vector<ObstacleId> force;
    Objective objective = Objective::makespan;
    Connectivity connectivity = Connectivity::four;
    io::ImageReading image;

    std::optional<Planner> planner;
    std::optional<Heuristic> heuristic;
    std::optional<double> weight;
    std::optional<TieBreak> tie_break;
    std::optional<Corners> corners;
    std::optional<double> radius;
    std::optional<bool> diagonal;
    std::uint64_t expansion_limit = UINT64_MAX;

    std::optional<double> cell_size;
    std::string json;
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

// Start and goal of the map file, where it holds them, unless the options say otherwise.
Mission mission_of(const PlanOptions& options, const io::MapFile& map);

// The options, else what --paper stands for, else what the map file says, else the defaults.
MissionOptions mission_options_of(const PlanOptions& options, const io::MapFile& map);

}  // namespace waybreaker::apps
