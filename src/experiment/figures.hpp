// Figures: the paper's figures 3 to 7 from a summary, each with what the paper says of it and what is measured here.
#pragma once

#include <string>
#include <vector>

#include "experiment/summary.hpp"
#include "render/chart.hpp"

namespace waybreaker::experiment {

// A number as people read it: four significant digits at most.
std::string four_digits(double value);

struct Figure {
    std::string file;  // its name without extension
    render::Chart chart;
    std::string says;                   // the paper
    std::vector<std::string> measured;  // here, one sentence a series
    std::string note;                   // how to read it; may be empty
};

// The figures of the paper.
std::vector<Figure> paper_figures(const SetSummary& summary);

// How much each set of missions gains, for the paper's conjecture that mazes and spirals gain more. For two sets or
// more.
Figure conjecture_figure(const std::vector<SetSummary>& sets);

}  // namespace waybreaker::experiment
