// Caption: a plan's figures in words, as a picture shows them.
#pragma once

#include <string>
#include <vector>

#include "waybreaker/map.hpp"
#include "waybreaker/mission.hpp"
#include "waybreaker/plan.hpp"

namespace waybreaker::render {

struct PictureOptions;

// The plan in one sentence: "Makespan 584.0 → 552.1 s at 1 m/s (−5.5 %), 3 openings, 640 m², gap 0.2 %".
std::string headline(const Map& map, const Mission& mission, const Plan& plan, const PictureOptions& options);

// A time as in the headline, without its unit: "208.7".
std::string time_text(double time, const Mission& mission, const PictureOptions& options);

// The unit of all times of the picture.
std::string time_unit(const Mission& mission, const PictureOptions& options);

struct FigureRow {
    std::string name;
    std::string before;
    std::string after;
    std::string change;
};

// What is measured in one unit.
struct FigureGroup {
    std::string name;  // "length in metres"
    std::vector<FigureRow> rows;
};

// Lengths of path A and path B; times: makespan and flowtime. Before and after.
std::vector<FigureGroup> figures(const Mission& mission, const Plan& plan, const PictureOptions& options);

}  // namespace waybreaker::render
