// Missions under way in which a vehicle clears for others.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <string>

#include "checked_plan.hpp"
#include "live/underway.hpp"
#include "waybreaker/revise.hpp"

namespace waybreaker {
namespace {

Underway any_clearing_underway() {
    Underway drawn = any_clearing(12, 1, Left::perhaps_rubble);
    double last = 0;
    for (const Itinerary& agent : drawn.plan.agents) last = std::max(last, agent.path.back().t);
    drawn.state.sequence = 1;
    drawn.state.now = last * *number(0, 100) / 100;
    return drawn;
}

RC_GTEST_PROP(ReviseClearing, WithoutNewsIsNoLater, ()) {
    const Underway old = any_clearing_underway();
    Planner planner;
    const Revision next = revise(planner, old.map, old.mission, old.plan, old.state);
    RC_CLASSIFY(next.status == RevisionStatus::kept);
    RC_CLASSIFY(!old.plan.breaches.empty() && old.plan.breaches.front().by == "rover0");
    RC_ASSERT(next.plan.status == PlanStatus::solved);
    RC_ASSERT(revision_faults(old, next) == "");
    const Objective objective = old.mission.rules.objective;
    const double least = objective == Objective::flowtime ? 0 : old.state.now;
    const double reached = value(next.plan.after, objective).value();
    RC_ASSERT(objective == Objective::flowtime ||
              reached <= std::max(value(old.plan.after, objective).value(), least) * (1 + 1e-9));
}

RC_GTEST_PROP(ReviseClearing, AfterAFailedBreachTheRestIsValid, ()) {
    Underway old = any_clearing_underway();
    RC_PRE(!old.plan.breaches.empty());
    const Breach failed = old.plan.breaches[std::size_t(*number(0, int(old.plan.breaches.size()) - 1))];
    old.state.now = failed.cleared_at;
    old.state.failed = {{failed.obstacle, failed.cleared_at}};
    Planner planner;
    const Revision next = revise(planner, old.map, old.mission, old.plan, old.state);
    RC_CLASSIFY(next.plan.status == PlanStatus::solved);
    if (next.plan.status != PlanStatus::solved) return;
    RC_ASSERT(revision_faults(old, next) == "");
}

// An aircraft that has landed, and may not breach any more, stands where it is.
TEST(ReviseClearing, AnAircraftThatIsHomeBeginsThere) {
    const Map map = Map::from_rows({
        "....A....",
        "....A....",
        "....A....",
        "....A....",
        ".........",
    });
    Mission mission{
        {vehicle("dozer", {0, 1}, {8, 1}), vehicle("rover", {0, 3}, {8, 3}), aircraft("air", {0, 1}, {3, 1})}, {}};
    mission.agents[0].own_breaches = 1;
    mission.agents[1].speed = 0.5;
    mission.agents[2].speed = 2;
    mission.agents[2].breaches = 1;
    mission.rules.removals = 1;
    Underway old{map, mission, Planner().plan(map, mission)};
    ASSERT_EQ(old.plan.breaches.size(), 1U);
    ASSERT_EQ(old.plan.breaches[0].by, "air");
    old.state = {.sequence = 1, .now = 5, .agents = {{.id = "rover", .passed = 0, .at = Point(1, 3)}}};
    Planner planner;
    const Revision next = revise(planner, old.map, old.mission, old.plan, old.state);
    ASSERT_EQ(next.plan.status, PlanStatus::solved);
    EXPECT_EQ(revision_faults(old, next), "");
}

RC_GTEST_PROP(ReviseClearing, AfterAnyNewsTheRestIsValid, ()) {
    expect_valid_after_any_news(any_clearing_underway());
}

}  // namespace
}  // namespace waybreaker
