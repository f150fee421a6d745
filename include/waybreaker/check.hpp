// Check: judges a plan from the map alone.
//
//     for (const Violation& violation : check(map, mission, plan)) std::cerr << violation.message << '\n';
//
// The judge shares no geometry with the planners, only cells and ids: every blocked cell near the ground agent's way
// is held against the definition (contract, section 2) one by one, in integers where touching must be told from
// meeting. Slow next to a planner, and obvious.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "waybreaker/map.hpp"
#include "waybreaker/mission.hpp"
#include "waybreaker/plan.hpp"
#include "waybreaker/state.hpp"
#include "waybreaker/words.hpp"

namespace waybreaker {

enum class Rule {
    map,         // made for this map
    status,      // solved or not, and figures and agents accordingly
    agents,      // those of the mission, with speeds and paths
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
    breach,      // an air agent of the plan is there as long as the breach takes
    order,       // each air agent makes one breach after the other, listed in that order
    next,        // what would be removed next may be, and is not yet
    entered,     // entered_at is when a ground agent first touches the obstacle
    length,
    makespan,
    flowtime,
    ground_makespan,
    before,  // the figures without removal fit together
    bound,   // not below 0, nor above what the plan reaches, nor what is reached without removals
    gap,
    separation,  // no two ground agents overlap, at any time
    capacity,    // no air agent breaches more obstacles than it may
    saves,       // what a removal saves leaves no plan below the bound
    gain,        // an agent's gain follows from its path and its way without removals
    waits,       // who is said to wait stands there, for what can be in its way then
    orders,      // whoever keeps them is safe, however late anybody is, and nobody waits for ever
    surface,     // what a ground agent drives over is what the plan file says it is
    continuity,  // a revision goes on from where everybody is
    if_failed,   // a failed breach leaves no plan below the bound, nor more removals than allowed
    zone,        // agents keep out of zones that hold for them; what is removed reaches into none for vehicles
    range,       // no aircraft flies farther than it may; what is out of range is
    endurance,   // ... or longer
    rubble,      // who drives through what was removed takes its time
};

template <>
inline constexpr std::array<std::string_view, 39> words_of<Rule>{
    "map",       "status",     "agents",     "start",    "goal",     "time",      "speed",           "vertex",
    "collision", "obstacle",   "repetition", "removals", "budget",   "cells",     "boundary",        "breach",
    "order",     "next",       "entered",    "length",   "makespan", "flowtime",  "ground_makespan", "before",
    "bound",     "gap",        "separation", "capacity", "saves",    "gain",      "waits",           "orders",
    "surface",   "continuity", "if_failed",  "zone",     "range",    "endurance", "rubble"};

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
// asked. Numbers may be off by `tolerance`, a share of themselves, of 1 if they are smaller, of 1000 if they are
// larger; places where the air agent breaches by `tolerance` cells, however fast it is. A ground agent of radius 0 may
// bend at cell corners. Where numbers of the plan are infinite or none, nothing else is judged. Throws InputError if
// the mission's bodies, times or budget, or the tolerance, are out of range; ids of obstacles that the map has not are
// judged. Orders are judged where nothing else is wrong. Time O(length of the ground paths * radius) plus O(obstacles),
// and for a team O(points of the paths) for each pair of agents whose ways come near each other; any plan can be
// judged, however broken.
[[nodiscard]] std::vector<Violation> check(const Map& map, const Mission& mission, const Plan& plan,
                                           double tolerance = 1e-6);

// Whether a plan that revises another, from a state, goes on from there: everybody where the state or the old plan has
// them, on their bases until they decide; what is open, failed or used up is known; nobody new, and nobody missing.
// Whether the plan is valid in itself, on the map as it is known then, is for check().
[[nodiscard]] std::vector<Violation> check_continuity(const Mission& old_mission, const Plan& old_plan,
                                                      const State& state, const Mission& mission, const Plan& plan,
                                                      double tolerance = 1e-6);

}  // namespace waybreaker
