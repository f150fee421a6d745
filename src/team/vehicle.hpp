// A ground agent of a team, and what is known of it alone.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/stopwatch.hpp"
#include "drive/opening.hpp"
#include "waybreaker/advanced/crossing.hpp"
#include "waybreaker/mission.hpp"

namespace waybreaker::team {

// A map with obstacles removed, and when those of them that stand at first are gone.
struct Ground {
    OpenedMap map;
    std::vector<TimedOpening> openings = {};
    double rubble = 0;  // Rules::rubble
};

struct Vehicle {
    Agent agent;
    std::vector<Cell> way;  // the shortest that was found for it alone
    double alone = 0;       // when it arrives on that, with no stop but for what opens late
    double bound = 0;       // it arrives no earlier, whatever the others do
    bool limited = false;   // a limit ended the search for its way: there may be a shorter one
    std::uint64_t expanded = 0;
    std::uint64_t generated = 0;
    double seconds = 0;
};

// Limits of all searches of a team.
struct Interrupts {
    Deadline deadline;
    StopToken stop;
    std::uint64_t expansions = UINT64_MAX;
    double gap = 0;  // a share: a plan within it of the bound is good enough
    unsigned threads = 1;

    bool good_enough(double objective, double bound) const { return gap > 0 && objective <= bound * (1 + gap); }
    bool due() const { return stop.stop_requested() || deadline.passed(); }
    // How a method ends that may miss a plan and has found none.
    SearchStatus end_without_plan(bool limited) const {
        if (stop.stop_requested()) return SearchStatus::stopped;
        return limited || deadline.passed() ? SearchStatus::limit_reached : SearchStatus::not_found;
    }
    Limits limits() const { return {.seconds = deadline.left(), .expansions = expansions, .stop = stop}; }
};

// Whether the crossing search drives such a body: for a point it bends at corners of cells.
bool drives_by_crossing(const Body& body);

// The agent on its way, as in a mission of its own: by the crossing search if that drives it, else by Theta*.
Trip trip_of(const Map& map, const Agent& agent, const Interrupts& interrupts, double rubble);

// The cells of a path that bends at centres.
std::vector<Cell> cells_of(std::span<const Point> path);

// Who has no way counts as if it arrived at Rules::unreached, and so does who would arrive later.
void count_unreached(const Rules& rules, Vehicle& vehicle);

// Its shortest way, as in a mission of its own; or the earliest one found, where obstacles of those removed open late.
// `found`: the vehicle is complete. Anything else is why it is not.
SearchStatus go_alone(const Ground& ground, const Interrupts& interrupts, CrossingSearcher& crossing, Searcher& theta,
                      Vehicle& vehicle);

}  // namespace waybreaker::team
