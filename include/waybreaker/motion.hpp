// How the ground agent may move (contract, section 2).
#pragma once

#include "waybreaker/map.hpp"

namespace waybreaker {

// Which blocked side cells a diagonal step may pass. `none`: neither (a disc agent); `cut`: one; `squeeze`: both.
// With cut and squeeze the agent is a point.
enum class Corners { none, cut, squeeze };

struct Motion {
    Corners corners = Corners::none;
    double radius = 0.5;   // of the disc agent, in cells: 0.5 to 32, thousandths count; used with Corners::none
    bool diagonal = true;  // eight neighbours; false: four
};

// Throws InputError if the rules contradict each other or are out of range.
void validate(const Motion& motion);

// Whether the agent can stand on a cell of the map.
bool fits(const OpenedMap& map, Cell at, const Motion& motion = {});

// Whether the agent can move straight from one cell centre to another: exact, in integers. Symmetric.
// Precondition: both cells lie on the map. False where the agent does not fit on either end.
bool line_of_sight(const OpenedMap& map, Cell from, Cell to, const Motion& motion = {});

}  // namespace waybreaker
