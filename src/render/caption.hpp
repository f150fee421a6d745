// Caption: a plan's figures in words, as a picture shows them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "waybreaker/map.hpp"
#include "waybreaker/mission.hpp"
#include "waybreaker/plan.hpp"

namespace waybreaker::render {

struct PictureOptions;

// The plan in one sentence: "Makespan 584.0 → 552.1 s at 1 m/s (−5.5 %), 3 openings, 640 m², gap 0.2 %". What the plan
// was asked to make small comes first.
std::string headline(const Map& map, const Mission& mission, const Plan& plan, const PictureOptions& options);

// A time as in the headline, without its unit: "208.7".
std::string time_text(double time, const Mission& mission, const PictureOptions& options);

// What a unit of the mission's time is in them.
double time_factor(const Mission& mission, const PictureOptions& options);

// The unit of all times of the picture.
std::string time_unit(const Mission& mission, const PictureOptions& options);

// The times that say how good a plan is: its objective, then makespan and flowtime.
std::vector<Objective> shown_times(Objective objective);

// What a figure is called in a table: "makespan", "flowtime"; the ground agents' is the "last vehicle" of a team.
std::string_view name_of(Objective objective, const Mission& mission);

struct FigureRow {
    std::string name;
    std::string before;
    std::string after;
    std::string change;
    bool is_objective = false;
};

// What is measured in one unit.
struct FigureGroup {
    std::string name;  // "length in metres"
    std::vector<FigureRow> rows;
};

// Lengths of path A and path B; shown_times. Before and after.
std::vector<FigureGroup> figures(const Mission& mission, const Plan& plan, const PictureOptions& options);

}  // namespace waybreaker::render
