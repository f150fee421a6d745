// The options of `waybreaker plan` for teams: several ground agents, and their aircraft.
#pragma once

#include <optional>
#include <vector>

#include "plan_options.hpp"

namespace waybreaker::apps {

void add_team_options(CLI::App& command, PlanOptions& options);

// Where aircraft start and end, if that is said.
struct Base {
    std::optional<Cell> start;
    std::optional<Cell> goal;
};

// The first lines of the scenario file, named by their numbers, and the aircraft. Throws InputError if the file has
// less, or is for another map.
std::vector<Agent> team_of(const PlanOptions& options, const Map& map, const Base& base);

// As many aircraft as asked for in place of the one that the mission has at its end.
void share_out_flight(const PlanOptions& options, Mission& mission);

// Throws InputError if two options say who the agents are, or one is for agents that no other one names.
void validate_sources_of_agents(const PlanOptions& options);

// Throws InputError if options that are for teams, or not for them, are given where they are not in place.
void validate_team_options(const PlanOptions& options, const Mission& mission);

}  // namespace waybreaker::apps
