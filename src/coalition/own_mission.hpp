// A vehicle's own mission: with all aircraft, and no other vehicle. A plan for all is one for it as well, so the bound
// of its own mission is one for the makespan of all; and what it would remove, where it would drive and how aircraft
// would fly for it is good for all where they wait for this vehicle.
#pragma once

#include <vector>

#include "coalition/problem.hpp"
#include "coalition/workers.hpp"
#include "select/candidate.hpp"

namespace waybreaker::coalition {

struct OwnMission {
    struct Proposal {
        Candidate candidate;
        double objective = 0;
    };
    std::vector<Proposal> proposals = {};  // that have a path; the best first
    double bound = 0;                      // no plan of the own mission has a smaller objective
};

// As the planner of one vehicle plans it.
OwnMission plan_own_mission(const Problem& problem, std::size_t vehicle, Worker& worker);

}  // namespace waybreaker::coalition
