// Whether a plan says rightly what its vehicles drive over.
//
// Shares no code with site/surface.hpp: each cell near the path is clipped against it for itself, and what the cells of
// one sort have of the path together is measured, whichever other cells have it as well.
#pragma once

#include <vector>

#include "io/check_report.hpp"

namespace waybreaker::io {

// Of a map that knows no ways nothing is judged where another map file will do. REQUIRES: a map of the plan's size, and
// nothing else wrong with it.
std::vector<Violation> judge_surfaces(const PlanFile& plan, const MapFile& map, const JudgeOptions& options);

}  // namespace waybreaker::io
