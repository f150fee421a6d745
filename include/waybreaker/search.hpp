// Search: a shortest ground path by best-first search, with the paper's hit counting inside.
//
//     Searcher searcher;                                        // keeps its memory between queries
//     SearchResult r = searcher.find(OpenedMap(map), {1, 1}, {60, 40}, {.planner = Planner::theta});
//     if (r.status == SearchStatus::found) drive(r.path);
//
// Theta*: Nash, Daniel, Koenig, Felner 2007. Lazy Theta*: Nash, Koenig, Tovey 2010. JPS: Harabor, Grastien 2011.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "waybreaker/body.hpp"
#include "waybreaker/limits.hpp"
#include "waybreaker/map.hpp"

namespace waybreaker {

// `optimal` is the crossing search with nothing to cross (crossing.hpp); a mission can ask for it, a Searcher cannot.
enum class Planner { theta, lazy_theta, astar, jps, dijkstra, bfs, optimal };
enum class Heuristic { euclidean, octile, chebyshev, manhattan, zero };
enum class TieBreak { g_max, g_min };

class SearchListener;

inline constexpr double most_heuristic_weight = 1e6;

struct SearchOptions {
    Planner planner = Planner::theta;
    // Default: euclidean for theta and lazy_theta, octile for astar and jps (manhattan without diagonal moves).
    // Dijkstra and BFS use none.
    std::optional<Heuristic> heuristic = std::nullopt;
    double weight = 1.0;  // of the heuristic, 1 to most_heuristic_weight
    TieBreak tie_break = TieBreak::g_max;
    bool diagonal = true;     // eight neighbours; false: four
    Body body = {};           // of the ground agent
    bool count_hits = false;  // fill SearchResult::hits
    Limits limits = {};
    SearchListener* listener = nullptr;  // not owned; called at every step
};

// Whether Planner::optimal moves an agent of that body: one that passes no blocked corner, by eight moves.
bool can_drive_optimally(const Body& body, bool diagonal);

// The heuristic that a search with these options uses.
Heuristic heuristic_of(const SearchOptions& options);

// `no_path`: there is none. `not_found`: the search ended by itself without a path and without a proof that there is
// none. `limit_reached`, `stopped`: it ended early.
enum class SearchStatus { found, no_path, not_found, limit_reached, stopped };

// Whether what it has not found is not there.
constexpr bool came_to_its_end(SearchStatus status) {
    return status == SearchStatus::found || status == SearchStatus::no_path;
}

struct SearchResult {
    SearchStatus status = SearchStatus::no_path;
    std::vector<Cell> path;       // turning points from start to goal; empty unless found
    double length = 0;            // of the path, in cells
    std::uint64_t expanded = 0;   // nodes taken from the open list, the goal included
    std::uint64_t generated = 0;  // expanded plus what is left in the open list
    // If asked for: hits[id] = how often the search tried to step onto obstacle `id` (paper, Algorithm 1, lines 11-13).
    std::vector<std::uint32_t> hits;
};

// Hears a search as it runs; for traces and pictures. g and f are in cells, f includes the weighted heuristic.
class SearchListener {
  public:
    virtual ~SearchListener() = default;
    virtual void generated(Cell cell, Cell parent, double g, double f) = 0;
    virtual void updated(Cell cell, Cell parent, double g, double f) = 0;
    virtual void expanded(Cell cell, Cell parent, double g, double f) = 0;
};

// Throws InputError, naming the option, if the options contradict each other or are out of range.
void validate(const SearchOptions& options);

class Searcher {
  public:
    Searcher();
    ~Searcher();
    Searcher(Searcher&&) noexcept;
    Searcher& operator=(Searcher&&) noexcept;

    // Finds a path from start to goal. A start or goal that is blocked or off the map has no path. Throws InputError if
    // the options are invalid. Memory: 16 bytes a cell of the largest map seen plus the open list; a query touches only
    // what it visits. Not for use by two threads at once.
    SearchResult find(const OpenedMap& map, Cell start, Cell goal, const SearchOptions& options = {});

  private:
    class Memory;
    std::unique_ptr<Memory> memory_;
};

}  // namespace waybreaker
