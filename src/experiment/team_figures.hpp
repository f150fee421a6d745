// Team figures: gap, time, success and flowtime against the size of the team.
#pragma once

#include <vector>

#include "experiment/figures.hpp"
#include "experiment/team_summary.hpp"

namespace waybreaker::experiment {

// None without teams. Intervals that would reach below 0 are left out.
std::vector<Figure> team_figures(const TeamSummary& summary);

}  // namespace waybreaker::experiment
