// The authors' XML task files: a grid, a start, a goal and search options in one.
//
//     <root>
//       <map> <width>3</width> <height>2</height> <cellsize>1</cellsize>
//             <startx>0</startx> <starty>0</starty> <finishx>2</finishx> <finishy>1</finishy>
//             <grid> <row>0 0 1</row> <row>0 0 0</row> </grid> </map>
//       <algorithm> <searchtype>theta</searchtype> <hweight>1</hweight> </algorithm>
//     </root>
//
// 1 is a blocked cell. Only width, height and grid must be there; tasks of AA-SIPP(m) have width and height as
// attributes of <grid>, and agents in place of the start and the goal (agents_xml.hpp). As in the authors' program,
// tags may be written in any case, unknown tags are passed over, and search options that are missing or unknown get
// their defaults: a searchtype that waybreaker does not have (`lian`, say) means theta, a breakingties other than g-min
// means g-max.
#pragma once

#include <string>
#include <string_view>

#include "io/map_file.hpp"
#include "waybreaker/grid.hpp"

namespace waybreaker::authors {

struct AuthorsXml {
    Grid grid;
    std::string title = {};
    double cell_size = 1;
    io::MapTask task = {};
};

// `name` is how the input is called in errors. Throws InputError with name and line. Nothing is allocated for the grid
// before its rows are known to be there and its size to be within the limits of grid.hpp.
AuthorsXml parse_authors_xml(std::string_view bytes, const std::string& name);

}  // namespace waybreaker::authors
