// A team: paths for any number of ground agents that never collide.
//
// Most vehicles in a city have nobody in the way of their shortest path. The rest are planned one after the other past
// those planned before (safe_interval.hpp), which a large neighbourhood search then mends where it found no way, and
// improves while there is time and gain.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "team/fleet.hpp"
#include "team/vehicle.hpp"

namespace waybreaker::team {

struct TeamPlan {
    // `found`: every vehicle has a path. `no_path`: some vehicle has no way at all, were it alone. Else: a limit.
    SearchStatus status = SearchStatus::no_path;
    std::vector<Vehicle> vehicles;  // in the mission's order
    std::vector<Path> paths;        // of each; empty unless found
    bool limited = false;           // a limit ended a search or the improvement
};

// Calls `improved` with the paths' cost whenever there is a better plan, the first included. The same mission has the
// same plan, time limits aside.
TeamPlan plan_team(const OpenedMap& map, const Mission& mission, const Interrupts& interrupts,
                   CrossingSearcher& crossing, Searcher& theta, const std::function<void(const Cost&)>& improved);

// Asked when there is a plan: the vehicles' objective that needs no more improvement. May raise their bounds.
using Enough = std::function<double(std::span<Vehicle>)>;

// The vehicles' objective if nobody lost time on the others.
double objective_alone(std::span<const Vehicle> vehicles, Objective objective);

// The same for vehicles that know their ways, on ground that opens in time.
TeamPlan plan_paths(const Ground& ground, std::vector<Vehicle> vehicles, const Rules& rules,
                    const Interrupts& interrupts, const Enough& enough,
                    const std::function<void(const Cost&)>& improved);

}  // namespace waybreaker::team
