// Every plan that the planner makes passes the checker, whatever the method and the agents.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "checked_plan.hpp"
#include "random_map.hpp"

namespace waybreaker {
namespace {

Motion any_way_to_move() {
    const Corners corners = any_corners();
    return {.corners = corners,
            .radius = corners == Corners::none ? *rc::gen::element(0.5, 0.5, 0.501, 0.75, 1.2, 2.0) : 0.5,
            .diagonal = true};
}

// A mission that can be put on the map, with agents of their own speeds, starts and goals.
Mission any_mission(const PlainMap& plain, const Map& map, const Motion& motion) {
    Mission mission = ground_and_air(any_free_cell(plain), any_free_cell(plain));
    const OpenedMap closed(map);
    RC_PRE(fits(closed, mission.agents[0].start, motion) && fits(closed, mission.agents[0].goal, motion));
    if (*rc::gen::arbitrary<bool>()) mission.agents[1].start = any_cell(plain);
    if (*rc::gen::arbitrary<bool>()) mission.agents[1].goal = any_cell(plain);
    mission.agents[0].speed = *rc::gen::element(0.3, 1.0, 1.0, 7.0);
    mission.agents[1].speed = *rc::gen::element(0.5, 1.0, 1.0, 4.0);
    if (*rc::gen::arbitrary<bool>()) std::swap(mission.agents[0], mission.agents[1]);
    return mission;
}

MissionOptions any_options(const Map& map) {
    MissionOptions options;
    options.removals = *number(0, 4);
    options.flight = *rc::gen::element(FlightRule::optimal, FlightRule::nearest);
    options.timing = *rc::gen::element(Timing::enforce, Timing::ignore);
    options.objective = *rc::gen::element(Objective::makespan, Objective::flowtime, Objective::ground_makespan);
    options.breach_time = {*rc::gen::element(0.0, 0.0, 2.5), *rc::gen::element(0.0, 0.0, 0.2)};
    options.protect = some_obstacles(map, 2);
    options.weights.assign(map.obstacles().size() + 1, *rc::gen::element(0.5, 1.0));
    options.budget = *rc::gen::element(0.9, 1.7, std::numeric_limits<double>::infinity());
    options.bound = *rc::gen::arbitrary<bool>();
    options.explain = *rc::gen::arbitrary<bool>();
    return options;
}

// The paper's choice and the proven one, with every planner that drives from cell to cell.
RC_GTEST_PROP(EveryPlan, IsValid, ()) {
    const PlainMap plain = *random_map(24, 20);
    const Map map(plain.grid(), *rc::gen::element(Connectivity::four, Connectivity::eight));
    MissionOptions options = any_options(map);
    options.select = *rc::gen::element(Selection::hits, Selection::exact);
    options.search.planner = *rc::gen::element(Planner::theta, Planner::lazy_theta, Planner::astar, Planner::jps,
                                               Planner::dijkstra, Planner::bfs);
    options.search.motion = any_way_to_move();
    if (options.search.planner == Planner::jps) options.search.motion.radius = 0.5;
    const Mission mission = any_mission(plain, map, options.search.motion);
    const Plan plan = MissionPlanner().plan(map, mission, options);
    RC_ASSERT(plan_faults(map, mission, options, plan) == "");
}

// The proven choice with the optimal planner, for the unit square and for the point.
RC_GTEST_PROP(EveryPlan, IsValidWithTheOptimalPlanner, ()) {
    const PlainMap plain = *random_map(24, 20);
    const Map map(plain.grid(), *rc::gen::element(Connectivity::four, Connectivity::eight));
    MissionOptions options = any_options(map);
    options.select = Selection::exact;
    options.search.planner = Planner::optimal;
    options.search.motion.radius = *rc::gen::element(0.5, 0.0);
    const Mission mission = any_mission(plain, map, {});
    const Plan plan = MissionPlanner().plan(map, mission, options);
    RC_ASSERT(plan_faults(map, mission, options, plan) == "");
}

}  // namespace
}  // namespace waybreaker
