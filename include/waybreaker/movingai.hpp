// MovingAI benchmark files: `.map` and `.scen` (Sturtevant 2012). Standard library only.
//
//     std::ifstream in("Berlin_0_512.map");
//     Map map(read_movingai_map(in, "Berlin_0_512.map"));
//
// Terrain: `.` and `G` (ground), `S` (swamp; in warehouses of the League of Robot Runners a service point) and `E`
// (there an emitter point) are passable, everything else is blocked. Lines end in LF or CRLF, perhaps after blanks. A
// scenario file may lack its `version` line; columns are separated by tabs or spaces, and between tabs the map's name
// may hold blanks.
#pragma once

#include <istream>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "waybreaker/grid.hpp"

namespace waybreaker {

// `name` is how the input is called in errors. Throws InputError with name and line. Nothing is allocated for a map
// before its rows are known to be there and its size to be within the limits of grid.hpp.
Grid read_movingai_map(std::istream& in, const std::string& name);
Grid read_movingai_map(std::string_view bytes, const std::string& name);

// The text of a map file: `.` where a cell is free, `@` where it is blocked.
std::string movingai_map(const Grid& grid);

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
std::vector<Scenario> read_movingai_scenarios(std::string_view bytes, const std::string& name);

// The text of a scenario file of version 1, columns between tabs. Throws InputError for a map whose name is empty or
// holds what would end its column.
std::string movingai_scenarios(std::span<const Scenario> scenarios);

}  // namespace waybreaker
