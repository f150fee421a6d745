// Plans as the authors' XML log: their task file, and in <log> what their program writes there.
//
//     <log> <mapfilename>yard.map</mapfilename>
//           <summary numberofsteps="7" nodescreated="12" length="20.1" length_scaled="48.2" time="0.0007"/>
//           <path> <row number="0">0 0 * 1 ...</row> ... </path>          the opened map, * where the ground agent goes
//           <lplevel> <node x="1" y="5" number="0"/> ... </lplevel>       the cells it passes
//           <hplevel> <section number="0" start.x=... length="9.4"/> ... </hplevel>   the straight pieces
//           <destroyed> <obstacle number="0" id="17" x="8" y="4" time="7.1"/> ... </destroyed>
//           <airlevel> <node x="1" y="5" number="0"/> ... </airlevel> </log>
//
// <destroyed> and <airlevel>, in the style of the rest, are ours.
#pragma once

#include <string>

#include "io/map_file.hpp"
#include "waybreaker/plan.hpp"
#include "waybreaker/search_options.hpp"

namespace waybreaker::authors {

// Precondition: the plan is one for this map. Throws InputError if the ground agent turns elsewhere than at the centres
// of cells.
std::string plan_xml(const Plan& plan, const io::MapFile& map, const SearchOptions& search);

}  // namespace waybreaker::authors
