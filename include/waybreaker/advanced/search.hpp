// Search: a shortest ground path by best-first search, with the paper's hit counting inside.
//
//     Searcher searcher;                                        // keeps its memory between queries
//     SearchResult r = searcher.find(OpenedMap(map), {1, 1}, {60, 40}, {.planner = Algorithm::theta});
//     if (r.status == SearchStatus::found) drive(r.path);
//
// Theta*: Nash, Daniel, Koenig, Felner 2007. Lazy Theta*: Nash, Koenig, Tovey 2010. JPS: Harabor, Grastien 2011.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

#include "waybreaker/map.hpp"
#include "waybreaker/search_options.hpp"  // IWYU pragma: export
#include "waybreaker/words.hpp"

namespace waybreaker {

// `no_path`: there is none. `not_found`: the search ended by itself without a path and without a proof that there is
// none. `limit_reached`, `stopped`: it ended early.
enum class SearchStatus { found, no_path, not_found, limit_reached, stopped };
template <>
inline constexpr std::array<std::string_view, 5> words_of<SearchStatus>{"found", "no_path", "not_found",
                                                                        "limit_reached", "stopped"};

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

    // Searches on until every cell that has a path is expanded, for the listener of the options: it hears of each once,
    // the nearest first. Without a heuristic, so not by JPS. Throws and remembers as find.
    void explore(const OpenedMap& map, Cell start, SearchOptions options);

  private:
    class Memory;
    std::unique_ptr<Memory> memory_;
};

}  // namespace waybreaker
