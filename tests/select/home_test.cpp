// The flight home counts where an aircraft does not end where the drive ends.
#include <gtest/gtest.h>

#include "checked_plan.hpp"
#include "waybreaker/planner.hpp"

namespace waybreaker {
namespace {

// Blocks of eight cells between streets of four.
Map blocks(int width, int height) {
    Grid grid(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) grid.set_blocked({x, y}, x % 12 >= 4 && y % 12 >= 4);
    }
    return Map(grid);
}

// The best plan past what is forced, of all single blocks.
double best_of_one(const Map& map, Mission mission, const Plan& without) {
    double best = *without.after.makespan;
    for (const Obstacle& obstacle : map.obstacles()) {
        mission.rules.force = {obstacle.id};
        const Plan plan = Planner().plan(map, mission);
        if (plan.status == PlanStatus::solved) best = std::min(best, *plan.after.makespan);
    }
    return best;
}

TEST(Home, IsFlownFromTheBestOfAllBlocks) {
    const Map map = blocks(160, 160);
    int gains = 0;
    for (const Cell goal : {Cell{133, 122}, Cell{145, 73}, Cell{50, 145}, Cell{145, 145}}) {
        Mission mission = ground_and_air({1, 1}, goal);
        mission.agents[1].goal = mission.agents[1].start;
        mission.rules.removals = 0;
        const Plan without = Planner().plan(map, mission);
        mission.rules.removals = 1;
        const Plan plan = Planner().plan(map, mission);
        EXPECT_EQ(plan_faults(map, mission, plan), "");
        const double best = best_of_one(map, mission, without);
        EXPECT_LE(*plan.after.makespan, best * 1.001);
        EXPECT_LE(plan.bound.value(), best + 1e-6);
        gains += best < *without.after.makespan ? 1 : 0;
    }
    EXPECT_GT(gains, 2);
}

}  // namespace
}  // namespace waybreaker
