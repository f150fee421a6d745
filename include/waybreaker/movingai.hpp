// MovingAI benchmark files: `.map` and `.scen` (Sturtevant 2012). Standard library only.
//
// Terrain: `.` and `G` (ground) and `S` (swamp) are passable, everything else is blocked. Lines end in LF or CRLF.
#pragma once

#include <istream>
#include <string>
#include <vector>

#include "waybreaker/grid.hpp"

namespace waybreaker {

// `name` is how the input is called in errors. Throws InputError with name and line; sizes over the limits of grid.hpp
// are refused before anything is allocated.
Grid read_movingai_map(std::istream& in, const std::string& name);

struct Scenario {
    int bucket = 0;
    std::string map;
    int width = 0;
    int height = 0;
    Cell start;
    Cell goal;
    double optimal_length = 0;  // octile, without corner cutting; in cells
};

std::vector<Scenario> read_movingai_scenarios(std::istream& in, const std::string& name);

}  // namespace waybreaker
