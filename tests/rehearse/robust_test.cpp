// Of plans that are about as good as planned, the one that is best as played.
#include <gtest/gtest.h>

#include <vector>

#include "ascii_map.hpp"
#include "vehicle.hpp"
#include "waybreaker/planner.hpp"
#include "waybreaker/rehearse.hpp"

namespace waybreaker {
namespace {

// The lower street is the shortest once A is gone, and a vehicle that finds A standing has to go all the way back. The
// upper street needs nobody, and is a little longer: it leads around C, which stays.
struct TwoStreets {
    Map map = Map::from_rows({
        ".....................",
        "..........C..........",
        ".BBBBBBBBBBBBBBBBBBB.",
        "..................A..",
    });
    Mission mission = ground_and_air({0, 2}, {20, 2});
    std::vector<Plan> plans = {};

    explicit TwoStreets(const std::vector<Agent>& others = {}) {
        mission.agents.insert(mission.agents.end(), others.begin(), others.end());
        mission.rules.removals = 1;
        mission.rules.protect = {map.obstacle_at({10, 1}), map.obstacle_at({10, 2})};
        plans = Planner().alternatives(map, mission, 0.1);
    }
    std::vector<Rehearsal> rehearsed(double fail) const {
        std::vector<Rehearsal> rehearsals;
        for (const Plan& plan : plans) rehearsals.push_back(rehearse(map, mission, plan, {.fail = fail, .runs = 100}));
        return rehearsals;
    }
};

TEST(Robust, IsWhatDependsOnNoBreachWhereBreachesFail) {
    const TwoStreets streets;
    ASSERT_EQ(streets.plans.size(), 2U);
    EXPECT_EQ(streets.plans[0].breaches.size(), 1U);
    EXPECT_EQ(streets.plans[1].breaches.size(), 0U);
    const std::vector<Rehearsal> rehearsals = streets.rehearsed(0.1);
    EXPECT_EQ(most_robust(rehearsals, Objective::makespan), 1U);
    // A failure costs the whole way back: one in ten costs more than the longer street.
    EXPECT_GT(rehearsals[0].makespan.mean, rehearsals[1].makespan.mean + 1);
    EXPECT_NEAR(rehearsals[1].makespan.mean, *streets.plans[1].after.makespan, 1e-9);
}

TEST(Robust, IsOfATeamAsWell) {
    const TwoStreets streets({vehicle("other", {0, 0}, {4, 0}), aircraft("second", {0, 0}, {0, 0})});
    ASSERT_EQ(streets.plans.size(), 2U);
    EXPECT_EQ(streets.plans[0].breaches.size(), 1U);
    EXPECT_EQ(most_robust(streets.rehearsed(0.1), Objective::makespan), 1U);
    EXPECT_EQ(most_robust(streets.rehearsed(0), Objective::makespan), 0U);
}

TEST(Robust, IsTheFastestWhereNothingFails) {
    const TwoStreets streets;
    EXPECT_EQ(most_robust(streets.rehearsed(0), Objective::makespan), 0U);
}

TEST(Robust, PrefersMissionsThatArrive) {
    std::vector<Rehearsal> rehearsals(3);
    rehearsals[0] = {.arrived = 9, .makespan = {.mean = 1}, .ground_makespan = {.mean = 1}};
    rehearsals[1] = {.arrived = 10, .makespan = {.mean = 3}, .ground_makespan = {.mean = 2}};
    rehearsals[2] = {.arrived = 10, .makespan = {.mean = 2}, .ground_makespan = {.mean = 2}};
    EXPECT_EQ(most_robust(rehearsals, Objective::makespan), 2U);
    EXPECT_EQ(most_robust(rehearsals, Objective::ground_makespan), 1U);
}

}  // namespace
}  // namespace waybreaker
