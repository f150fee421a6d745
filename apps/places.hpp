// Places of a mission in the words of the user: cells, metres of the map's frame, or degrees.
#pragma once

#include <string>

#include "plan_options.hpp"
#include "waybreaker/place_error.hpp"

namespace waybreaker::apps {

// A cell as the options give places: "2,5", or with --map-metres "-2.75,0.25 (cell 2,5)".
std::string place_text(Cell cell, const PlanOptions& options, const io::MapFile& map);

// Why an agent cannot start or end where it should; unknown ground is called so.
std::string why_misplaced(const Misplaced& agent, const PlanOptions& options, const io::MapFile& map);

}  // namespace waybreaker::apps
