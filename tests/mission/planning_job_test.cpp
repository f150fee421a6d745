// Planning in slices gives the plan of planning at once, wherever the slices end.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <chrono>
#include <utility>

#include "random_map.hpp"
#include "waybreaker/planner.hpp"

namespace waybreaker {
namespace {

using std::chrono::nanoseconds;

// A wall across with a hole at the far end, and two pieces to break.
Map level() {
    return Map::from_rows({
        ".....A..........",
        ".....A..........",
        ".....A....B.....",
        ".....C....B.....",
        ".....C....B.....",
        "..........B.....",
    });
}

Mission mission() {
    Mission asked = ground_and_air({0, 2}, {15, 2});
    asked.rules.removals = 2;
    asked.rules.breach_time.per_obstacle = 1;
    return asked;
}

// Everything but the measured times.
bool same(const Plan& one, const Plan& other) {
    const auto breached = [](const Plan& plan) {
        std::vector<std::pair<ObstacleId, double>> all;
        for (const Breach& breach : plan.breaches) all.emplace_back(breach.obstacle, breach.cleared_at);
        return all;
    };
    const auto expanded = [](const Plan& plan) {
        std::vector<std::uint64_t> all;
        for (const Route& route : plan.after.routes) all.push_back(route.expanded);
        return all;
    };
    return one.status == other.status && one.after.makespan == other.after.makespan && one.bound == other.bound &&
           one.gap == other.gap && one.limit_reached == other.limit_reached && breached(one) == breached(other) &&
           expanded(one) == expanded(other) &&
           std::ranges::equal(one.agents, other.agents, {}, &Itinerary::path, &Itinerary::path);
}

TEST(PlanningJob, GivesThePlan) {
    const Map map = level();
    Planner planner;
    PlanningJob job = planner.start(map, mission());
    EXPECT_FALSE(job.done());
    int steps = 0;
    while (!job.step(nanoseconds(0))) ++steps;
    EXPECT_GT(steps, 1) << "each step ends where the planner looks next";
    EXPECT_TRUE(job.done());
    EXPECT_TRUE(job.step(nanoseconds(0)));
    EXPECT_TRUE(same(job.plan(), Planner().plan(map, mission())));
}

TEST(PlanningJob, PlanGoesOnUntilItIsThere) {
    const Map map = level();
    Planner planner;
    const Plan expected = Planner().plan(map, mission());
    EXPECT_TRUE(same(planner.start(map, mission()).plan(), expected)) << "without a step";
    PlanningJob job = planner.start(map, mission());
    job.step(nanoseconds(0));
    EXPECT_TRUE(same(job.plan(), expected)) << "after one";
    PlanningJob whole = planner.start(map, mission());
    EXPECT_TRUE(whole.step(nanoseconds::max()));
}

TEST(PlanningJob, LeavesThePlannerWhenItIsGone) {
    const Map map = level();
    Planner planner;
    { const PlanningJob never_stepped = planner.start(map, mission()); }
    {
        PlanningJob job = planner.start(map, mission());
        job.step(nanoseconds(0));
        PlanningJob moved = std::move(job);
        moved.step(nanoseconds(0));
    }
    EXPECT_TRUE(same(planner.plan(map, mission()), Planner().plan(map, mission())));
}

TEST(PlanningJob, SaysWhatIsWrongAtOnce) {
    const Map map = level();
    Planner planner;
    EXPECT_THROW(static_cast<void>(planner.start(map, ground_and_air({0, 0}, {99, 0}))), InputError);
}

TEST(PlanningJob, HeedsTheStopTokenAndReportsWithinSteps) {
    const Map map = level();
    Planner planner;
    StopSource stop;
    PlanningJob job = planner.start(map, mission(), {}, {.stop = stop.get_token()});
    job.step(nanoseconds(0));
    stop.request_stop();
    EXPECT_EQ(to_string(job.plan().status), "stopped");
    int reports = 0;
    bool stepping = false;
    PlanningJob reporting = planner.start(map, mission(), {}, {.progress = [&](const Progress&) {
                                              EXPECT_TRUE(stepping);
                                              ++reports;
                                          }});
    for (bool done = false; !done;) {
        stepping = true;
        done = reporting.step(nanoseconds(0));
        stepping = false;
    }
    EXPECT_GT(reports, 0);
}

RC_GTEST_PROP(PlanningJob, GivesThePlanOfAnyMission, ()) {
    const PlainMap blocks = *random_map(20, 20);
    RC_PRE(!blocks.free_cells().empty());
    const Map map(blocks.grid());
    Mission asked = ground_and_air(any_free_cell(blocks), any_free_cell(blocks));
    asked.rules.removals = *number(0, 3);
    if (*rc::gen::arbitrary<bool>()) {
        asked.agents.push_back(vehicle("other", any_free_cell(blocks), any_free_cell(blocks)));
        asked.rules.at_goal = AtGoal::leave;
        RC_PRE(distance(asked.agents[0].start, asked.agents[2].start) >= 1);
    }
    Planner planner;
    PlanningJob job = planner.start(map, asked);
    const nanoseconds slice(*rc::gen::element(0, 1000, 100000));
    while (!job.step(slice)) {
    }
    RC_ASSERT(same(job.plan(), Planner().plan(map, asked)));
}

}  // namespace
}  // namespace waybreaker
