// A coalition: vehicles that never collide, and aircraft that breach obstacles for all of them together.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "coalition/evaluation.hpp"
#include "team/team.hpp"

namespace waybreaker::coalition {

struct CoalitionPlan {
    // `found`: every agent has a path. `no_path`: some vehicle has no way, whatever is removed. Else: a limit.
    SearchStatus status = SearchStatus::no_path;
    std::vector<team::Vehicle> closed;  // each vehicle alone, nothing removed; without a way where it has none
    team::TeamPlan team;                // the vehicles; their ways those that they would drive if they were alone
    std::vector<team::Path> flights;    // of the aircraft; in the mission's order
    std::vector<Breach> breaches;       // in order of time; entered_at is not known yet
    double objective = infinity;        // of the plan
    double bound = 0;                   // no plan has a smaller objective
    bool proven = false;                // whether that bound was looked for
    bool limited = false;
    bool missed = false;  // vehicles did not get past each other with a set that promised as much
    // Where a share is given: other sets that were evaluated, each as a plan; the best first, collisions aside.
    std::vector<CoalitionPlan> alternatives;
};

// Which sets of obstacles are evaluated, beside what must be removed.
enum class Selecting {
    none,     // none
    exact,    // those that a relaxation points to, with a bound on all others
    greedy,   // those that grow by the obstacle that gains most each time
    listed,   // the first of a list, the first two, and so on
    as_list,  // all of the list, whatever that costs
};

struct Choice {
    Selecting selecting = Selecting::exact;
    std::vector<ObstacleId> list = {};  // without what must be removed and what may not; cut to what the rules allow
    // Whether a bound is proven; `exact` always proves one.
    bool proves_bound = true;
    // Of the plan's objective: sets that cost more than it by no more than that are planned as well, once it is there.
    std::optional<double> share = {};
};

// Whether plans that may remove less are made as well, where the choice is exact: another choice of sets may do better.
// Those that a bound shows to be no better are left out. A time limit leaves them out, too, where vehicles lose next to
// nothing on each other.
enum class Fewer { tried, not_tried };

// Evaluates sets of obstacles, and plans the vehicles past each other with the best of them. "Remove nothing" is one of
// the sets unless something must be, or the choice is a whole list. Calls `improved` as team::plan_paths does. The same
// mission has the same plan, time limits aside. REQUIRES: the mission is a team's with an aircraft.
CoalitionPlan plan_coalition(const Map& map, const Mission& mission, const Choice& choice, Fewer fewer,
                             const team::Interrupts& interrupts, CrossingSearcher& crossing, Searcher& theta,
                             const std::function<void(double objective, double bound)>& improved);

}  // namespace waybreaker::coalition
