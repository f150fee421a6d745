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

// Whether the mission is one of agents that a file lists: that of --agents, or the map's own where no option says a
// place.
bool lists_agents(const PlanOptions& options, const io::MapFile& map);

// The first of these agents, those of scenarios named by their numbers, and the aircraft. Throws InputError if there
// are fewer, or scenarios are for a map of another size; warns if for one of another name. REQUIRES: lists_agents.
std::vector<Agent> team_of(const PlanOptions& options, const io::MapFile& map, const Base& base);

// As many aircraft as asked for in place of the one that the mission has at its end.
void share_out_flight(const PlanOptions& options, Mission& mission);

// Throws InputError if two options say who the agents are, or one is for agents that no other one names.
void validate_sources_of_agents(const PlanOptions& options, const io::MapFile& map);

// Throws InputError if options that are for teams, or not for them, are given where they are not in place.
void validate_team_options(const PlanOptions& options, const io::MapFile& map, const Mission& mission);

}  // namespace waybreaker::apps
