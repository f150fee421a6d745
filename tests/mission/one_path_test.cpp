// A set of removed obstacles has one path, whatever else was asked for.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <vector>

#include "ascii_map.hpp"
#include "random_map.hpp"
#include "vehicle.hpp"
#include "waybreaker/planner.hpp"

namespace waybreaker {
namespace {

// One base.
Mission any_pair_from_one_base(const PlainMap& plain) {
    const Cell start = any_free_cell(plain);
    const Cell goal = any_free_cell(plain);
    Mission mission{{vehicle("rover", start, goal), aircraft("heli", start, goal)}};
    mission.agents[0].body.radius = *rc::gen::element(0.0, 0.2, 0.36, 0.4, 0.5, 0.5);
    mission.rules.removals = *number(1, 3);
    mission.rules.objective = *rc::gen::element(Objective::makespan, Objective::flowtime, Objective::ground_makespan);
    mission.rules.breach_time.per_obstacle = *rc::gen::element(0.0, 0.0, 3.0);
    return mission;
}

RC_GTEST_PROP(OnePath, OfASetWhateverMayBeRemoved, ()) {
    const PlainMap plain = *random_map(16, 14);
    const Map map(plain.grid());
    const Mission mission = any_pair_from_one_base(plain);
    const Method method{.select = *rc::gen::element(Selection::exact, Selection::greedy)};
    const Plan plan = Planner().plan(map, mission, method);
    Mission none = mission;
    none.rules.removals = 0;
    const Plan without = Planner().plan(map, none, method);
    RC_ASSERT(plan.before.makespan == without.before.makespan);
    RC_ASSERT(plan.before.ground().path == without.before.ground().path);
    if (plan.status != PlanStatus::solved || method.select != Selection::exact) return;
    // Its own set, and no other.
    Mission same = mission;
    same.rules.removals = int(plan.breaches.size());
    for (const Breach& breach : plan.breaches) same.rules.force.push_back(breach.obstacle);
    const Plan forced = Planner().plan(map, same, method);
    RC_ASSERT(forced.after.makespan == plan.after.makespan);
}

TEST(OnePath, OfADiscThatNeedsLessThanTheSquare) {
    const Map map = map_from_ascii(R"(
        ##.........
        #..........
        #.....#....
        #..........
        #..........
        .......#..#
        ...........
        #..........
        ....#..#...)");
    Mission mission{{vehicle("rover", {10, 3}, {7, 7}), aircraft("heli", {10, 3})}};
    mission.agents[0].body.radius = 0.5;
    std::vector<double> before;
    for (mission.rules.removals = 0; mission.rules.removals < 3; ++mission.rules.removals) {
        before.push_back(*Planner().plan(map, mission).before.ground_makespan);
    }
    EXPECT_EQ(before, std::vector<double>(3, before.front()));
}

}  // namespace
}  // namespace waybreaker
