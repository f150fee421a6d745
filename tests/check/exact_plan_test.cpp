// Paths of the crossing search, timed by the schedule, pass the checker: for the square and the point, all speeds and
// breach times.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "checked_plan.hpp"
#include "crossing/access.hpp"
#include "hand_made.hpp"
#include "orders/orders.hpp"
#include "random_map.hpp"
#include "waybreaker/advanced/crossing.hpp"
#include "waybreaker/advanced/schedule.hpp"

namespace waybreaker {
namespace {

// A plan without figures of the mission before.
Plan plan_of(const Map& map, const ScheduleTask& task, const Schedule& schedule) {
    std::vector<Breach> removed;
    for (std::size_t i = 0; i < schedule.cleared_at.size(); ++i) {
        const BreachPoint& breach = schedule.flight.breaches[i];
        removed.push_back({.obstacle = breach.obstacle,
                           .cells = map.obstacle(breach.obstacle).cells,
                           .at = breach.at,
                           .cleared_at = schedule.cleared_at[i],
                           .entered_at = schedule.entered_at[i]});
    }
    Plan plan = hand_made(schedule.ground, schedule.air, removed);
    plan.agents[0].speed = task.driver.speed;
    plan.agents[1].speed = task.flyer.speed;
    plan.after.makespan = schedule.makespan;
    plan.after.flowtime = schedule.flowtime;
    return plan;
}

RC_GTEST_PROP(ExactPlan, IsValid, ()) {
    const PlainMap plain = *random_map(20, 20);
    const Map map(plain.grid(), *rc::gen::element(Connectivity::four, Connectivity::eight));
    const Body body = *rc::gen::element(Body{}, point_body);
    const int crossings = *number(0, 4);
    const CrossingOptions options{.body = body, .crossings = crossings};
    const double least = *rc::gen::element(0.0, 10.0, 60.0);
    crossing::Opener opener;
    opener.done_after = [least](std::span<const ObstacleId> crossed) { return crossed.empty() ? 0 : least; };
    const Cell start = any_free_cell(plain);
    const Cell goal = any_free_cell(plain);
    CrossingSearcher searcher;
    const CrossingResult result = crossing::Access::find(searcher, map, start, goal, options, opener);
    RC_PRE(result.status == SearchStatus::found);
    Mission mission = ground_and_air(any_cell(plain), any_cell(plain));
    Agent& driver = mission.agents[0];
    Agent& flyer = mission.agents[1];
    driver.body = body;
    driver.speed = *rc::gen::element(0.5, 1.0, 4.0);
    flyer.speed = *rc::gen::element(0.5, 1.0, 4.0);
    mission.rules.removals = crossings;
    mission.rules.breach_time = {*rc::gen::element(0.0, 0.0, 3.0), *rc::gen::element(0.0, 0.0, 0.3)};
    const ScheduleTask task{.ground_path = result.best.path,
                            .driver = driver,
                            .flyer = flyer,
                            .rules = mission.rules,
                            .removed = result.best.crossed};
    Plan plan = plan_of(map, task, best_schedule(map, task));
    driver.start = plan.agents[0].start;
    driver.goal = plan.agents[0].goal;
    add_orders(map, mission, plan);
    std::string faults;
    for (const Violation& violation : check(map, mission, plan)) faults += line_of(violation) + "\n";
    RC_ASSERT(faults == "");
}

}  // namespace
}  // namespace waybreaker
