// Crossing: the shortest any-angle path that crosses at most so many obstacles, with proof.
//
//     CrossingSearcher searcher;                                   // keeps its memory between queries
//     CrossingResult r = searcher.find(map, {1, 1}, {60, 40}, {.crossings = 2});
//     if (r.status == SearchStatus::found) breach(r.best.crossed); // each obstacle once, in the order of the path
//
// With no crossings this is the optimal any-angle planner. Theorem, model and proof: docs/exact.md.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "waybreaker/advanced/search.hpp"
#include "waybreaker/map.hpp"

namespace waybreaker {

struct CrossingOptions {
    // With corners `none`. A disc of radius up to 0.5 is searched as the unit square around it, which does not turn;
    // its path bends at cell centres. A wider disc is that square on a map grown by the disc, cell by cell, which is
    // kept for the next query: what is found is legal for the disc, and near the best. The path of a point (radius 0)
    // bends at cell corners, may touch obstacles and slip between diagonal neighbours. All start and end at cell
    // centres.
    Body body = {};
    // A lower limit instead: the path of a point on a map grown by less than the body, which slips between diagonal
    // neighbours only where obstacles open late. No path of the body that bends at cell centres and crosses as much is
    // shorter.
    bool relaxed = false;
    int crossings = 0;  // at most so many distinct obstacles, however often each is crossed
    // Crossed for nothing, as if they were gone; and never crossed. Indestructible obstacles never are.
    std::span<const ObstacleId> removed = {};
    std::span<const ObstacleId> protect = {};
    std::span<const ObstacleId> only = {};                    // if not empty: no others are crossed
    double budget = std::numeric_limits<double>::infinity();  // the crossed weigh at most so much together
    // How many cells the agent could drive until the last of these obstacles is open; never less for more of them; at
    // or below 0: they are open from the start. The agent waits for that, wherever at the border of an obstacle the
    // rest of the way is shortest. Empty: all are open.
    std::function<double(std::span<const ObstacleId>)> opened_after = {};
    // What a path pays beside all else for each obstacle that it crosses: by id, in cells, none below 0. Empty:
    // nothing.
    std::span<const double> prices = {};
    double length_limit = std::numeric_limits<double>::infinity();  // dearer paths are not looked for
    // Above 1: any path that costs at most so many times the least; it is found much sooner (weighted A*: Pohl,
    // "Heuristic search viewed as path finding in a graph", 1970). Only for `find`, where nothing opens late.
    double weight = 1;
    double expected = 0;  // a guess of the cost, cells: near above it, the search is fastest
    Limits limits = {};
};

// A wait at the border of an obstacle.
struct CrossingGate {
    Point at;
    std::vector<ObstacleId> crossed;  // by then, the obstacle it waits for excluded
};

struct CrossingPath {
    std::vector<Point> path;          // turning points from start to goal
    double length = 0;                // cells
    double cost = 0;                  // cells: driven, waited for obstacles to open, and paid
    std::vector<ObstacleId> crossed;  // in the order of the path, each once; without those of `removed`
    // Where it waits. A path of the relaxed body is a lower limit: it may come to a gate through what stands, half a
    // cell early.
    std::vector<CrossingGate> gates = {};
};

struct CrossingResult {
    // `not_found`: around a disc wider than 0.5 so many obstacles overlap that the grown map would take much more
    // memory than the map; then the lower bound is the straight line.
    SearchStatus status = SearchStatus::no_path;
    CrossingPath best;  // if found; the best known, or empty, if a limit ended the search
    // No path costs less: the cost if found; for `no_path` the `length_limit`, or infinity if start or goal are closed;
    // what was proven by then if a limit ended the search.
    double lower_bound = 0;
    std::uint64_t expanded = 0;
    std::uint64_t generated = 0;
};

namespace crossing {
struct Access;  // of the planner's own parts
}

class CrossingSearcher {
  public:
    CrossingSearcher();
    ~CrossingSearcher();
    CrossingSearcher(CrossingSearcher&&) noexcept;
    CrossingSearcher& operator=(CrossingSearcher&&) noexcept;

    // The shortest path; of equally short ones always the same. No path if start or goal lie in an obstacle that is not
    // removed, or off the map. Cost grows with the ellipse that the path needs, not with the map. Throws InputError on
    // options out of range, and on such answers of `opened_after`. Not for use by two threads at once.
    CrossingResult find(const Map& map, Cell start, Cell goal, const CrossingOptions& options = {});

    // For each set of at most `crossings` obstacles that no set within it beats: a path of least cost, in order of
    // cost, to `accept` until that says false. A set that is just as dear as one within it, but for rounding, may be
    // told of as well. The result's lower_bound is what all paths not told of cost at least.
    CrossingResult enumerate(const Map& map, Cell start, Cell goal, const CrossingOptions& options,
                             const std::function<bool(const CrossingPath&)>& accept);

  private:
    friend struct crossing::Access;
    class Search;
    explicit CrossingSearcher(std::unique_ptr<Search> search);
    std::unique_ptr<Search> search_;
};

}  // namespace waybreaker
