// A ground agent of a team, and what is known of it alone.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/stopwatch.hpp"
#include "waybreaker/crossing.hpp"
#include "waybreaker/mission.hpp"

namespace waybreaker::team {

struct Vehicle {
    Agent agent;
    std::vector<Cell> way;  // the shortest that was found for it alone
    double alone = 0;       // when it arrives on that, without a stop
    double bound = 0;       // it arrives no earlier, whatever the others do
    std::uint64_t expanded = 0;
    std::uint64_t generated = 0;
    double seconds = 0;
};

// What holds for all searches of a team.
struct Interrupts {
    Deadline deadline;
    StopToken stop;
    std::uint64_t expansions = UINT64_MAX;

    bool due() const { return stop.stop_requested() || deadline.passed(); }
    Limits limits() const { return {.seconds = deadline.left(), .expansions = expansions, .stop = stop}; }
};

// Whether the crossing search drives such a body: for a point it bends at corners of cells, and a wide disc needs room
// to spare.
bool drives_by_crossing(const Body& body);

// The cells of a path that bends at centres.
std::vector<Cell> cells_of(std::span<const Point> path);

// Its shortest way, by the crossing search where that drives it and by Theta* where not. `found`: the vehicle is
// complete. Anything else is why it is not.
SearchStatus go_alone(const OpenedMap& map, const Interrupts& interrupts, CrossingSearcher& crossing, Searcher& theta,
                      Vehicle& vehicle);

}  // namespace waybreaker::team
