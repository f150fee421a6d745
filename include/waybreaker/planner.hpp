// Planner: the paper's method from mission to plan.
//
//     MissionPlanner planner;                                   // keeps its memory between missions
//     Plan plan = planner.plan(map, ground_and_air({12, 20}, {400, 380}), {}, {.seconds = 1});
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "waybreaker/crossing.hpp"
#include "waybreaker/limits.hpp"
#include "waybreaker/map.hpp"
#include "waybreaker/mission.hpp"
#include "waybreaker/plan.hpp"
#include "waybreaker/search.hpp"

namespace waybreaker {

// How obstacles are selected: `exact` proves how far from the best its choice can be, `hits` is the paper's rule,
// `greedy` takes again and again the one whose removal shortens the ground path most, `none` takes none.
enum class Selection { exact, hits, greedy, none };
// How the air agent flies past them: the shortest way, or the paper's for more than one obstacle.
enum class FlightRule { optimal, nearest };

// How a mission is planned.
struct Method {
    Selection select = Selection::exact;
    FlightRule flight = FlightRule::optimal;
    // Of the ground agent; see planner_of. The members below are SearchOptions' own.
    Planner planner = Planner::optimal;
    std::optional<Heuristic> heuristic = std::nullopt;
    double weight = 1.0;
    TieBreak tie_break = TieBreak::g_max;
    bool diagonal = true;
    bool bound = false;    // prove a bound whatever the selection (`exact` always does)
    bool explain = false;  // what each removal saves, and which would come next
};

// The planner that drives the ground agent: the one asked for; Theta* in place of `optimal` where hits are to be
// counted, or the agent or its moves are none that `optimal` drives (can_drive_optimally).
Planner planner_of(const Method& method, const Body& body);

// The method's search of a ground agent, its planner that of planner_of.
SearchOptions search_options(const Method& method, const Body& body);

// Sets what the paper fixes: Theta*, most hits, obstacles gone from the start, and its flight rules (exact for one
// removal, nearest to the segment for more).
void follow_paper(Rules& rules, Method& method);

// Throws InputError, naming what is wrong, if the mission cannot be put on the map (validate of mission.hpp) or cannot
// be planned by the method, or a limit is none.
void validate(const Map& map, const Mission& mission, const Method& method, const Limits& limits = {});

class MissionPlanner {
  public:
    // Validates, searches the ground path without removal, selects obstacles (the paper's section 3, or with proof),
    // and puts both agents in time. With timing enforced no plan is worse than removing nothing, unless rules.force
    // demands removals. More removals can cost more where breaches take time, bases or speeds differ, or a limit ended
    // the choice (docs/exact.md, "What is not proven"). When limits.seconds are over: the best plan found by then, with
    // Plan::limit_reached. Keeps its memory between calls; not for two threads at once.
    Plan plan(const Map& map, const Mission& mission, const Method& method = {}, const Limits& limits = {});

    // What each further removal gains: the plans for 0, 1, 2, ... removals, up to the last that gains, at most
    // rules.removals. limits.seconds is that of all plans together; the last one is explained, if asked for.
    std::vector<Plan> front(const Map& map, const Mission& mission, const Method& method = {},
                            const Limits& limits = {});

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
// on the map costs the others nothing. The limits hold for each mission; limits.progress is called on several threads
// at a time.
std::vector<BatchPlan> plan_all(const Map& map, std::span<const Mission> missions, const Method& method = {},
                                const Limits& limits = {}, unsigned threads = 0);

}  // namespace waybreaker
