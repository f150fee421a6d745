// Script: an agent's path as a list of stops, with what it does at each and what it waits for there. Made of a plan's
// paths and orders; planned times are in it only of those whom zones hold for that have times.
#pragma once

#include <cstddef>
#include <vector>

#include "waybreaker/map.hpp"
#include "waybreaker/mission.hpp"
#include "waybreaker/plan.hpp"

namespace waybreaker::rehearsal {

// A place on a path at which something may happen: a point of it, or one on the way to the next.
struct Stop {
    std::size_t point = 0;  // of the path: this one, or the last before
    double share = 0;       // of the way to the next point
    Point at = {};
    double not_before = 0;                  // when it goes on, or has arrived
    bool on_time = false;                   // it is to go on at that time: zones have times
    double work = 0;                        // how long it is at work, or stands for rubble, before it is done here
    bool recharges = false;                 // it is at a base for that
    std::vector<ObstacleId> breaches = {};  // which then opens
    std::vector<std::size_t> signals = {};  // orders whose first event is that the agent got here
    std::vector<std::size_t> waits = {};    // orders whose second event is that it goes on from here
    std::vector<ObstacleId> gates = {};     // others open these: it goes on when they have
};

using Script = std::vector<Stop>;

// Whether a plan by these rules counts on that obstacle to open without it.
bool opens_by_itself(const Rules& rules, ObstacleId id);

// Of each agent of the plan. `standing`: obstacles that others are at work on, which are to open. `map`: as known then.
std::vector<Script> scripts_of(const Map& map, const Mission& mission, const Plan& plan,
                               const std::vector<ObstacleId>& standing);

}  // namespace waybreaker::rehearsal
