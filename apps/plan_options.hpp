// The options of `waybreaker plan`, and the mission they describe together with a map file.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "commands.hpp"
#include "io/map_file.hpp"
#include "io/mission_json.hpp"
#include "measure.hpp"
#include "overlay_options.hpp"
#include "page_planner.hpp"
#include "plan_exports.hpp"
#include "robust.hpp"
#include "waybreaker/method.hpp"

namespace waybreaker::apps {

// As given on the command line. What is optional can come from --paper or from the map file.
struct PlanOptions {
    std::string map;
    std::string mission;  // a mission file
    std::string agents;   // a scenario file
    std::optional<int> count;
    std::optional<int> aircraft;
    std::optional<int> breaches;      // of each
    std::optional<int> own_breaches;  // of the ground agent
    std::optional<GivenPlace> start;
    std::optional<GivenPlace> goal;
    std::optional<GivenPlace> air_start;
    std::optional<GivenPlace> air_goal;

    std::optional<int> removals;
    std::optional<Selection> select;
    std::optional<double> budget;
    std::string weights;
    unsigned threads = 0;  // 0: all cores
    std::optional<FlightRule> flight;
    std::optional<Measure> ground_speed;
    std::optional<Measure> air_speed;
    std::optional<Measure> range;      // of each aircraft
    std::optional<Measure> endurance;  // the same
    std::optional<double> reserve;
    std::optional<Measure> recharge;
    std::vector<GivenPlace> bases;  // of each aircraft
    std::optional<Measure> breach_time;
    std::optional<Measure> breach_time_per_cell;
    std::optional<Measure> rubble;
    std::vector<ObstacleId> protect;
    std::vector<site::TagFilter> protect_tags;  // beside these
    std::vector<ObstacleId> force;
    std::string zones;  // a file
    std::optional<Measure> separation;
    Connectivity connectivity = Connectivity::four;
    io::ImageReading image;
    OverlayOptions overlays;

    std::optional<Algorithm> planner;
    std::optional<Heuristic> heuristic;
    std::optional<double> weight;
    std::optional<TieBreak> tie_break;
    std::optional<Corners> corners;
    std::optional<Measure> radius;
    // What options say that no other one has to know of; over what --paper stands for.
    std::vector<std::function<void(io::MissionDocument&)>> said;

    std::optional<double> cell_size;
    std::string json;
    std::string save_mission;
    std::string svg;
    std::string png;
    std::string html;
    SteerableOptions steerable;
    std::string trace;
    PlanExports exports;
    RobustOptions robust;
    bool paper = false;
    bool removals_auto = false;  // as many removals as gain anything
    bool animate = false;        // the picture plays the plan
    bool area_budget = false;    // the budget is one of square metres
    bool bound = false;
    bool explain = false;
    bool plan_b = false;  // of each breach, what is left where it fails
    bool no_timing = false;
    bool lon_lat = false;     // places of agents are degrees
    bool map_metres = false;  // they are metres of the map's frame
};

// Reads an option of which no other has to know into a member of the mission: `member` gives a reference to it.
template <class Member>
auto says(PlanOptions& options, Member member) {
    return [&options, member](auto value) {
        options.said.emplace_back([member, value](io::MissionDocument& document) { member(document) = value; });
    };
}

void add_plan_options(CLI::App& command, PlanOptions& options);

// Throws InputError, naming the options, if they contradict each other.
void validate(const PlanOptions& options);

// What --paper and the list above make of the mission.
void say(const PlanOptions& options, io::MissionDocument& document);

// Whether an option applies only to a search with a heuristic.
bool needs_search(const PlanOptions& options);

// What obstacles weigh, by id, where the options say so; throws InputError if the mission contradicts that, and as
// io::read_weights does.
std::optional<std::vector<double>> weights_of(const PlanOptions& options, const io::MissionDocument& mission,
                                              const Map& map);

// What the mission file says, if there is one, with the overlays of the options.
io::MissionDocument given_mission(const PlanOptions& options);

// The options, else what the mission file says or --paper stands for, else what the map file says, else the defaults.
io::MissionDocument mission_of(const PlanOptions& options, io::MissionDocument given, const io::MapFile& map);

}  // namespace waybreaker::apps
