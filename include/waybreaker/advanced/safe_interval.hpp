// Safe intervals: the quickest any-angle way of one agent among others whose motion is known.
//
//     Traffic traffic(map.width(), map.height());
//     traffic.add(7, {{0, 4, 0}, {9, 4, 9}}, 0.5);              // disc 7 drives along row 4, and stays at its end
//     SafeIntervalSearcher searcher;                            // keeps its memory between queries
//     SafeIntervalResult r = searcher.find(OpenedMap(map), traffic, {4, 0}, {4, 8});
//     if (r.status == SearchStatus::found) drive(r.path);       // waits where it has to, and never meets disc 7
//
// The agent moves straight from one cell centre to another, at any angle and at its speed, and waits at centres only.
// A safe interval is a longest time for which it can stand at a centre; the search is over pairs of a cell and one of
// its safe intervals, and knows the earliest arrival at each. Phillips, Likhachev: SIPP, ICRA 2011; Yakovlev,
// Andreychuk: Any-angle pathfinding for multiple agents based on SIPP, ICAPS 2017 (section "AA-SIPP"). As Theta*, it
// finds a short way, not always the shortest; of those found each part is as early as it can be.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "waybreaker/advanced/search.hpp"
#include "waybreaker/body.hpp"
#include "waybreaker/limits.hpp"
#include "waybreaker/map.hpp"
#include "waybreaker/plan.hpp"

namespace waybreaker {

// Discs in motion. Two may touch, and overlap by `clearance_slack` cells, which is what rounding of times needs. A
// search lets them overlap by half of that: rounding does not make a path that it finds meet somebody, at times to
// 100,000.
inline constexpr double clearance_slack = 2e-9;

class Traffic;
namespace safe_interval {  // of the planner's own parts
class TrafficIndex;
const TrafficIndex& index_of(const Traffic& traffic);
}  // namespace safe_interval

class Traffic {
  public:
    // On a map of that size, all of them `separation` cells apart.
    Traffic(int width, int height, double separation = 0);
    ~Traffic();
    Traffic(Traffic&&) noexcept;
    Traffic& operator=(Traffic&&) noexcept;

    // A disc that follows the path: from its first point's time on, and if it `stays`, for ever at the last one.
    // `who` names it, and may not be there yet. Throws InputError if the radius, a place or a time is out of range, or
    // times decrease. Time O(length of the path).
    void add(std::uint32_t who, std::span<const Waypoint> path, double radius, bool stays = true);
    // Does nothing if it is not there.
    void remove(std::uint32_t who);

    // Those that a disc meets on that path, each once, in rising order. Time: what is near the path, at any time.
    std::vector<std::uint32_t> met(std::span<const Waypoint> path, double radius, bool stays = true) const;

  private:
    friend const safe_interval::TrafficIndex& safe_interval::index_of(const Traffic& traffic);
    std::unique_ptr<safe_interval::TrafficIndex> index_;
};

struct SafeIntervalOptions {
    Body body = {};
    double speed = 1;
    double since = 0;                             // from then on it is at its start
    double ready_at = 0;                          // stands there until then; arrives no earlier
    bool stays = true;                            // for ever at its goal: nobody else may come by later
    std::span<const TimedOpening> openings = {};  // in units of time
    double rubble = 0;                            // of each obstacle that the opened map is without (Rules::rubble)
    // A way from start to goal known beforehand, its turning points, legal for the body; found by Theta* where there is
    // none. Ways near it are tried first. Where an obstacle on it opens late, it is waited for at the last turn before.
    std::span<const Cell> known = {};
    // Arrivals that late are not looked for.
    double arrive_before = std::numeric_limits<double>::infinity();
    Limits limits = {};
};

struct SafeIntervalResult {
    SearchStatus status = SearchStatus::no_path;
    std::vector<Waypoint> path;  // from `since` on; empty unless found
    std::uint64_t expanded = 0;
};

class SafeIntervalSearcher {
  public:
    SafeIntervalSearcher();
    ~SafeIntervalSearcher();
    SafeIntervalSearcher(SafeIntervalSearcher&&) noexcept;
    SafeIntervalSearcher& operator=(SafeIntervalSearcher&&) noexcept;

    // An early way from start to goal that meets nobody: the known one, stopping only for what opens late, if it is
    // free; else the best of a search near it. On maps of up to four million cells, where that is more than ten cells
    // later than the known one would be, or none is found, the best of a search over all that can be reached in time.
    // So `no_path` means that no way was found, not that there is none. The same query has the same answer, time limits
    // aside. Throws InputError if options are out of range. Memory: about 24 bytes a cell that is searched, and 128 MB
    // of distances kept for later queries. Not for use by two threads at once.
    SafeIntervalResult find(const OpenedMap& map, const Traffic& traffic, Cell start, Cell goal,
                            const SafeIntervalOptions& options = {});

  private:
    class Search;
    std::unique_ptr<Search> search_;
};

}  // namespace waybreaker
