// Opening: obstacles to remove and the path that this opens to a ground agent that is alone.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "core/stopwatch.hpp"
#include "waybreaker/advanced/crossing.hpp"
#include "waybreaker/mission.hpp"
#include "waybreaker/plan.hpp"

namespace waybreaker {

// The searchers of ground paths; they keep their memory from mission to mission.
struct Searchers {
    Searcher& cells;
    CrossingSearcher& crossing;
};

// A ground agent on its way from its start to its goal, and what holds for all searches for it.
struct Trip {
    const Map& map;
    const Agent& driver;
    SearchOptions search;  // its limits aside; by the crossing search where the planner is the optimal one
    Deadline deadline;     // of the whole call
    std::uint64_t expansions = UINT64_MAX;
    StopToken stop = {};
    double rubble = 0;  // Rules::rubble

    bool by_crossing() const { return search.planner == Algorithm::optimal; }
    Limits limits(double seconds) const { return {.seconds = seconds, .expansions = expansions, .stop = stop}; }
    // Limits of a search from cell to cell that ends with the call's time: Theta* where the planner is the optimal one.
    SearchOptions by_cells() const;
};

struct Opening {
    std::vector<ObstacleId> removed;  // each once
    SearchStatus status = SearchStatus::no_path;
    Route ground = {};
    bool limited = false;  // a limit ended the search: there may be a shorter path
};

// How many cells the ground agent could drive until it is at the end of the path, no obstacle being late: the path's
// length, and what rubble on it takes; infinity if there is none.
double cells_driven(const Trip& trip, const Opening& opening);

// The path that a search found on the map without some obstacles; the crossing search's as the disc drives it.
Opening opening_of(std::vector<ObstacleId> removed, const SearchResult& search, double seconds);
Opening opening_of(const Trip& trip, std::vector<ObstacleId> removed, const CrossingResult& search, double seconds);

// Whether the unit square gets nearly as far as the disc within it (docs/exact.md, Theorem 2).
bool square_stands_for(const Body& body);

// The shortest ground path, by the trip's planner, on the map without some obstacles. Where the optimal one does not
// come in half the time that is left: Theta*'s. A disc that the square does not stand for drives the shortest of the
// paths that are known to it, Theta*'s among them; no path where none can be shorter than so many cells. Where there is
// rubble, the path leads through as many of them as is quickest. The same set always gives the same path.
Opening open(const Trip& trip, const Searchers& searchers, std::vector<ObstacleId> removed,
             double shorter_than = std::numeric_limits<double>::infinity());
// The same, of a set that a crossing search has found together with its path in so many seconds: a point drives that
// path. Of a square's equally short ones a disc may shorten each to another length, so a disc's is searched again; the
// path found is at hand if a limit ends that.
Opening open(const Trip& trip, const Searchers& searchers, std::vector<ObstacleId> removed, const CrossingResult& found,
             double seconds, double shorter_than = std::numeric_limits<double>::infinity());

// A path of the crossing search in time as the ground agent can drive it: the shortest ways to its gates. No path if a
// limit comes first. `removed`: what is open in the end.
Opening drivable(const Trip& trip, const Searchers& searchers, const CrossingPath& path,
                 std::vector<ObstacleId> removed);

}  // namespace waybreaker
