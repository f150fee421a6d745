// Mission: who must go where, and the paper's method from mission to plan.
//
//     MissionPlanner planner;
//     Plan plan = planner.plan(map, ground_and_air({12, 20}, {400, 380}), paper_options(3));
#pragma once

#include <string>
#include <vector>

#include "waybreaker/map.hpp"
#include "waybreaker/plan.hpp"
#include "waybreaker/search.hpp"

namespace waybreaker {

struct Agent {
    std::string id;
    AgentKind kind = AgentKind::ground;
    Cell start;
    Cell goal;
    double speed = 1;  // cells per unit of time, > 0
};

struct Mission {
    std::vector<Agent> agents;  // today: one ground agent and one air agent, in any order
};

// The paper's coalition: a ground agent and an air agent that start and end together.
Mission ground_and_air(Cell start, Cell goal);

enum class FlightRule { optimal, nearest };
enum class Objective { makespan, flowtime };

struct MissionOptions {
    int removals = 3;  // how many obstacles may be removed, >= 0
    FlightRule flight = FlightRule::optimal;
    Objective objective = Objective::makespan;
    SearchOptions search;  // of the ground agent; count_hits is set by the planner
};

// The paper's method with n removals: Theta*, most hits, its flight rules (exact for n = 1, nearest to the segment for
// more).
MissionOptions paper_options(int removals);

// Throws InputError, naming what is wrong, if the mission cannot be put on the map (an agent starts in a wall, is off
// the map, ...) or the options contradict each other.
void validate(const Map& map, const Mission& mission, const MissionOptions& options);

class MissionPlanner {
  public:
    // The paper's method (section 3), step by step; validates first. Keeps its memory between calls; not for two
    // threads at once.
    Plan plan(const Map& map, const Mission& mission, const MissionOptions& options = {});

  private:
    Searcher searcher_;
};

}  // namespace waybreaker
