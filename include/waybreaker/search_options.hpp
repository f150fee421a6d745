// Search options: how a ground path is searched. What a search does with them: search.hpp.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "waybreaker/body.hpp"
#include "waybreaker/cell.hpp"
#include "waybreaker/limits.hpp"
#include "waybreaker/words.hpp"

namespace waybreaker {

// How a search goes about it. `optimal` is the crossing search with nothing to cross (crossing.hpp); a mission can ask
// for it, a Searcher cannot.
enum class Algorithm { theta, lazy_theta, astar, jps, dijkstra, bfs, optimal };
template <>
inline constexpr std::array<std::string_view, 7> words_of<Algorithm>{"theta",    "lazy-theta", "astar",  "jps",
                                                                     "dijkstra", "bfs",        "optimal"};

enum class Heuristic { euclidean, octile, chebyshev, manhattan, zero };
template <>
inline constexpr std::array<std::string_view, 5> words_of<Heuristic>{"euclidean", "octile", "chebyshev", "manhattan",
                                                                     "zero"};

enum class TieBreak { g_max, g_min };
template <>
inline constexpr std::array<std::string_view, 2> words_of<TieBreak>{"g-max", "g-min"};

// Hears a search as it runs; for traces and pictures. g and f are in cells, f includes the weighted heuristic.
class SearchListener {
  public:
    virtual ~SearchListener() = default;
    virtual void generated(Cell cell, Cell parent, double g, double f) = 0;
    virtual void updated(Cell cell, Cell parent, double g, double f) = 0;
    virtual void expanded(Cell cell, Cell parent, double g, double f) = 0;
};

inline constexpr double most_heuristic_weight = 1e6;

struct SearchOptions {
    Algorithm planner = Algorithm::theta;
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

// Whether Algorithm::optimal moves an agent of that body: one that passes no blocked corner, by eight moves.
bool can_drive_optimally(const Body& body, bool diagonal);

// The heuristic that a search with these options uses.
Heuristic heuristic_of(const SearchOptions& options);

// Throws InputError, naming the option, if the options contradict each other or are out of range.
void validate(const SearchOptions& options);

}  // namespace waybreaker
