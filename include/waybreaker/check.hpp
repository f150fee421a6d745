// Check: judges a plan from the map alone.
//
//     const CheckRules rules{.timing = Timing::ignore, .removals = 1};
//     for (const Violation& violation : check(map, plan, rules)) std::cerr << violation.message << '\n';
//
// The judge shares no geometry with the planners, only cells and ids: every blocked cell near the ground agent's way
// is held against the definition (contract, section 2) one by one, in integers where touching must be told from
// meeting. Slow next to a planner, and obvious.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "waybreaker/map.hpp"
#include "waybreaker/motion.hpp"
#include "waybreaker/plan.hpp"

namespace waybreaker {

// What the plan says it keeps to.
struct CheckRules {
    Motion motion = {};  // its corners and radius; radius 0: a point that may bend at cell corners and slip between
                         // diagonal neighbours
    Timing timing = Timing::enforce;
    BreachTime breach_time = {};
    Objective objective = Objective::makespan;
    int removals = 3;                      // at most so many
    std::vector<ObstacleId> protect = {};  // never removed
    std::vector<ObstacleId> force = {};    // removed in any case
    // weights[i] of plan.removed[i] (empty: 1 each); their sum is at most `budget`.
    std::vector<double> weights = {};
    double budget = std::numeric_limits<double>::infinity();
    std::optional<double> gap = {};  // objective / bound - 1, if the plan states it
    // Numbers may be off by that share of themselves, below 1 by that much.
    double tolerance = 1e-6;
};

enum class Rule {
    map,         // made for this map
    status,      // solved or not, and figures and agents accordingly
    agents,      // one ground agent, one air agent, with speeds and paths
    start,       // paths start at the start at time 0 ...
    goal,        // ... and end at the goal
    time,        // times never decrease
    speed,       // who moves, moves at its speed
    vertex,      // ground paths bend at cell centres of the map
    collision,   // the ground agent meets nothing that stands at that moment
    obstacle,    // what is removed exists and may be removed
    repetition,  // ... once
    removals,    // ... and so many at most, with all that must be
    budget,      // ... or so heavy
    cells,       // and is what the plan says it is
    boundary,    // it is breached from its boundary
    breach,      // the air agent is there as long as the breach takes
    order,       // one breach after the other, listed in that order
    next,        // what would be removed next may be, and is not yet
    entered,     // entered_at is when the ground agent first touches the obstacle
    length,
    makespan,
    flowtime,
    ground_makespan,
    before,  // the figures without removal fit together
    bound,   // not above what the plan reaches, nor what is reached without removals
    gap,
};

// As written in reports: the word above.
std::string_view name(Rule rule);

struct Violation {
    Rule rule = Rule::map;
    std::string message = {};  // one line for a person, without place and time
    std::string agent = {};    // whose; empty where it is nobody's
    ObstacleId obstacle = {};
    std::optional<Point> place = {};
    std::optional<double> time = {};
};

// Everything that is wrong with the plan (after some thousand violations a path is not followed any further), in order
// of time, what has no time last; nothing if it is valid. Whether there is a better plan, or a plan at all, is not
// asked. Throws InputError if the rules are out of range. Time O(length of the ground path * radius) plus O(obstacles);
// any plan can be judged, however broken.
std::vector<Violation> check(const Map& map, const Plan& plan, const CheckRules& rules = {});

}  // namespace waybreaker
