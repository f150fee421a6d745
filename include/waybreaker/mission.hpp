// Mission: who must go where, and the paper's method from mission to plan.
//
//     MissionPlanner planner;
//     Plan plan = planner.plan(map, ground_and_air({12, 20}, {400, 380}), paper_options(3));
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "waybreaker/crossing.hpp"
#include "waybreaker/map.hpp"
#include "waybreaker/plan.hpp"
#include "waybreaker/schedule.hpp"
#include "waybreaker/search.hpp"

namespace waybreaker {

struct Agent {
    std::string id;
    AgentKind kind = AgentKind::ground;
    Cell start;
    Cell goal;
    double speed = 1;  // cells per unit of time, least_speed to most_speed
};

struct Mission {
    std::vector<Agent> agents;  // today: one ground agent and one air agent, in any order
};

// The paper's coalition: a ground agent and an air agent that start and end together.
Mission ground_and_air(Cell start, Cell goal);

// How obstacles are chosen: `exact` proves how far from the best its choice can be, `hits` is the paper's rule.
enum class Selection { exact, hits };
enum class FlightRule { optimal, nearest };

// What is known of the objective while obstacles are still being chosen.
struct Progress {
    double best = std::numeric_limits<double>::infinity();  // of the best plan so far
    double bound = 0;                                       // no plan is below it
};

struct MissionOptions {
    int removals = 3;  // how many obstacles may be removed, >= 0
    Selection select = Selection::exact;
    FlightRule flight = FlightRule::optimal;
    Timing timing = Timing::enforce;
    Objective objective = Objective::makespan;
    BreachTime breach_time = {};
    std::vector<ObstacleId> protect = {};  // never removed
    std::vector<ObstacleId> force = {};    // removed in any case; they count among the removals, and in the budget
    // weights[id], least_weight to most_weight, of every obstacle (empty: 1 each); the removed ones may weigh at most
    // `budget` together.
    std::vector<double> weights = {};
    double budget = std::numeric_limits<double>::infinity();
    bool bound = false;    // prove a bound whatever the method (`exact` always does)
    bool explain = false;  // what each removal saves, and which would come next
    // Time limit for the whole call, in seconds; on expiry the best plan found so far is returned, with
    // Plan::limit_reached. search.expansion_limit ends single searches.
    double time_limit = std::numeric_limits<double>::infinity();
    SearchOptions search = {.planner = Planner::optimal};  // of the ground agent; see planner_of
    // Told by `exact` now and then, on the thread that plans.
    std::function<void(const Progress&)> progress = {};
};

// The planner that drives the ground agent: the one asked for; Theta* in place of `optimal` where hits are to be
// counted or the agent is not one of radius 0.5 or 0 that passes no blocked corner.
Planner planner_of(const MissionOptions& options);

// The paper's method with n removals: Theta*, most hits, its flight rules (exact for n = 1, nearest to the segment for
// more).
MissionOptions paper_options(int removals);
// Other options, but the paper's method.
MissionOptions paper_options(MissionOptions options);

// Throws InputError, naming what is wrong, if the mission cannot be put on the map (an agent starts in a wall, is off
// the map, ...) or the options contradict each other.
void validate(const Map& map, const Mission& mission, const MissionOptions& options);

class MissionPlanner {
  public:
    // Validates, searches the ground path without removal, selects obstacles (the paper's section 3, or with proof),
    // and puts both agents in time. With timing enforced no plan is worse than removing nothing, unless options.force
    // demands removals. More removals can cost more where breaches take time, bases or speeds differ, or a limit ended
    // the choice (docs/exact.md, "What is not proven"). Keeps its memory between calls; not for two threads at once.
    Plan plan(const Map& map, const Mission& mission, const MissionOptions& options = {});

    // What each further removal gains: the plans for 0, 1, 2, ... removals, up to the last that gains, at most
    // options.removals. options.time_limit is that of all plans together; the last one is explained, if asked for.
    std::vector<Plan> front(const Map& map, const Mission& mission, const MissionOptions& options = {});

  private:
    Searcher searcher_;
    CrossingSearcher crossing_;
};

// A mission of a batch: its plan, or why it cannot be planned (the message of the InputError).
struct BatchPlan {
    std::optional<Plan> plan;
    std::string error;  // empty if there is a plan
};

// Plans each mission as MissionPlanner::plan does, over that many threads (0: all cores), and gives the results in the
// order of the missions: the same whatever the number of threads, measured seconds aside. A mission that cannot be put
// on the map costs the others nothing. options.time_limit holds for each mission; options.progress is called on several
// threads at a time.
std::vector<BatchPlan> plan_all(const Map& map, std::span<const Mission> missions, const MissionOptions& options = {},
                                unsigned threads = 0);

}  // namespace waybreaker
