// Caption: a plan's figures in words, as a picture shows them.
#pragma once

#include <string>
#include <vector>

#include "waybreaker/mission.hpp"
#include "waybreaker/plan.hpp"

namespace waybreaker::render {

struct PictureOptions;

// The plan in one sentence: "Makespan 584.0 → 552.1 m (−5.5 %), 3 obstacles removed, gap 0.2 %".
std::string headline(const Mission& mission, const Plan& plan, const PictureOptions& options);

// A time as the headline tells it, without its unit: "208.7".
std::string time_text(double time, const Mission& mission, const PictureOptions& options);

struct FigureRow {
    std::string name;
    std::string before;
    std::string after;
    std::string change;
};

// Path A, path B, makespan, flowtime, removals; before and after.
std::vector<FigureRow> figures(const Mission& mission, const Plan& plan, const PictureOptions& options);

}  // namespace waybreaker::render
