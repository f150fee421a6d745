// The mission document: what is asked, how it is planned, how long that may take. The command line, requests, mission
// files and files of missions fill one; plan files hold a copy.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "io/map_file.hpp"
#include "site/tag_filter.hpp"
#include "waybreaker/limits.hpp"
#include "waybreaker/method.hpp"
#include "waybreaker/mission.hpp"

namespace waybreaker::io {

struct MissionDocument {
    Mission mission = {};
    Method method = {};
    Limits limits = {};        // but for what stops or reports
    bool area_budget = false;  // the budget is one of square metres: obstacles weigh their area
    bool in_seconds = false;   // a unit of time is a second
    // What is protected beside mission.rules.protect, until the map is known.
    std::vector<site::TagFilter> protect_tags = {};
    // What agents, by their place in the mission, can breach beside CanBreach::only, until the map is known.
    std::map<std::size_t, std::vector<site::TagFilter>> can_breach_tags = {};
    // Ground agents, by their place in the mission, of which nobody has said how large they are; until the map is
    // known.
    std::vector<std::size_t> unsized = {};
    // Which map it is for, as seen from the document's file; empty where that is said elsewhere.
    std::string map = {};
    // What has to be laid over that map before anything is planned, the first one first.
    std::vector<site::OverlaySource> overlays = {};
};

// The radius, in cells, of a ground agent of which nobody says how large it is: by the profile of the map, else 0.5.
double usual_radius(const MapFile& file);

// Gives the usual radius to the agents that have none said, but for those that pass corners, which are points. Whether
// it differs from 0.5.
bool size_agents(MissionDocument& document, const MapFile& file);

// Makes the mission one of this map: what has the tags is named by its id, and the tags are gone. Gives the map to
// plan on where it differs: its obstacles weigh their area where the budget is one, else `weights` by id, if any.
// Throws InputError if nothing has a tag, the map does not say how large a cell is, or other overlays are laid over it
// than the mission is for.
std::optional<Map> resolve(MissionDocument& document, const MapFile& file,
                           const std::optional<std::vector<double>>& weights = {});

// All that makes a mission one of this map, for whoever plans it: sizes its agents, resolves it, and names the planner
// that drives its ground agent (planner_of).
std::optional<Map> settle(MissionDocument& document, const MapFile& file,
                          const std::optional<std::vector<double>>& weights = {});

// Throws what validate (method.hpp) throws. Why an agent is misplaced is said by what the map knows of the place.
void validate_on(const MapFile& file, const MissionDocument& document);

}  // namespace waybreaker::io
