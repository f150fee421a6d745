// The shortest tour of a few targets, with proof: see docs/flight.md.
#pragma once

#include "flight/target.hpp"

namespace waybreaker {

// The shortest tour over all orders and cells. Of tours whose lengths are equal as doubles the one whose first stop
// comes first in order of target, then scan order; then the second; and so on. `known` is any tour of the targets; the
// shorter it is, the faster this is. At most exact_flight_limit targets. Time and memory: 2^targets times the cells
// that a tour about as short as the shortest can use.
Tour shortest_tour(Cell start, Cell goal, std::span<const Target> targets, const Tour& known);

}  // namespace waybreaker
