// The shortest tour of a few targets, with proof: see docs/flight.md.
#pragma once

#include <optional>
#include <vector>

#include "flight/target.hpp"

namespace waybreaker {

// The shortest tour over all orders and cells. Of tours whose lengths are equal as doubles the one whose first stop
// comes first in order of target, then scan order; then the second; and so on. `known` is any tour of the targets; the
// shorter it is, the faster this is. At most exact_flight_limit targets. Time and memory: 2^targets times the cells
// that a tour about as short as the shortest can use.
Tour shortest_tour(Point start, Point goal, std::span<const Target> targets, const Tour& known,
                   const Airspace& air = {});

// Deadlines by which the air agent must be done with each target. Time is given in cells, as what it could fly
// meanwhile.
struct Deadlines {
    std::vector<double> stay;    // by target: how long it stays there
    std::vector<double> latest;  // by target: when it leaves at the latest; infinity: any time
};

// The shortest of the tours within the limit (stays not counted) that meet the deadlines; none if there is none.
// Deterministic; the nearer the limit, the faster. At most exact_flight_limit targets.
std::optional<Tour> shortest_tour_in_time(Point start, Point goal, std::span<const Target> targets,
                                          const Deadlines& deadlines, double limit, const Airspace& air = {});

}  // namespace waybreaker
