// Opening: obstacles to remove and the ground path that this opens. Candidate: an opening put in time with both agents,
// so that candidates can be compared.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "select/task.hpp"
#include "waybreaker/crossing.hpp"
#include "waybreaker/plan.hpp"
#include "waybreaker/schedule.hpp"

namespace waybreaker {

// Who finds ground paths; they keep their memory from mission to mission.
struct Searchers {
    Searcher& cells;
    CrossingSearcher& crossing;
};

struct Opening {
    std::vector<ObstacleId> removed;  // each once
    SearchStatus status = SearchStatus::no_path;
    Route ground = {};
    bool limited = false;  // a limit ended the search: there may be a shorter path
};

// What a search found on the map without some obstacles; the crossing search's path as the disc drives it.
Opening opening_of(std::vector<ObstacleId> removed, const SearchResult& search, double seconds);
Opening opening_of(const Task& task, std::vector<ObstacleId> removed, const CrossingResult& search, double seconds);

// Whether the unit square gets nearly as far as the disc within it (docs/exact.md, Theorem 2).
bool square_stands_for(const Body& body);

// Other discs than these drive a path along that of the relaxed body, or, if they know none, Theta*'s; if that could be
// shorter than so many cells.
void fit_to_disc(const Task& task, const Searchers& searchers, Opening& opening,
                 double shorter_than = std::numeric_limits<double>::infinity());

// Whether the crossing search drives the ground agent itself, for its body is one that it moves.
bool drives_by_crossing(const Task& task);

// Options of a search from cell to cell that ends with the call's time: Theta* where the task's planner is the optimal
// one.
SearchOptions cell_search(const Task& task);

// The shortest ground path, by the task's planner, on the map without some obstacles. Where the optimal one does not
// come in half the time that is left: Theta*'s.
Opening open(const Task& task, const Searchers& searchers, std::vector<ObstacleId> removed);

struct Candidate {
    Opening opening;
    Schedule schedule = {};     // of the air agent alone where there is no ground path
    double flight_seconds = 0;  // what it took to make the schedule
};

// Flies as the method says, with the time that is left to find out how. What the ground path does without stands again,
// but for what must be removed; not where obstacles do not stand in time (the paper).
Candidate candidate_of(const Task& task, Opening opening);

// The objective; infinity where there is no ground path.
double cost(const Task& task, const Candidate& candidate);

// The first of the best, gains that are rounding aside; `start` removes nothing but what must be. By hits, where
// obstacles do not stand in time (the paper): the last candidate whatever it costs.
const Candidate& best_of(const Task& task, const Candidate& start, const std::vector<Candidate>& candidates);

}  // namespace waybreaker
