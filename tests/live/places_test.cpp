// Many places under way: vehicles that may be anywhere at once, count for their weight, and may be left.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <string>

#include "ascii_map.hpp"
#include "checked_plan.hpp"
#include "live/underway.hpp"
#include "waybreaker/revise.hpp"

namespace waybreaker {
namespace {

Underway any_places_underway(int side) {
    Underway drawn = any_places(side, 1);
    drawn.state.sequence = 1;
    drawn.state.now = drawn.mission.rules.unreached.value_or(0) * *number(0, 99) / 100;
    return drawn;
}

RC_GTEST_PROP(RevisePlaces, WithoutNewsIsNoWorse, ()) {
    const Underway old = any_places_underway(12);
    Planner planner;
    const Revision next = revise(planner, old.map, old.mission, old.plan, old.state);
    RC_CLASSIFY(next.status == RevisionStatus::kept);
    RC_ASSERT(next.plan.status == PlanStatus::solved);
    RC_ASSERT(revision_faults(old, next) == "");
    // Aircraft that are home already may fly again, so they count as home no earlier than now.
    if (old.mission.rules.objective == Objective::flowtime) return;
    const auto reached = [&](const Plan& plan) { return *value(plan.after, old.mission.rules.objective); };
    RC_ASSERT(reached(next.plan) <= std::max(reached(old.plan), old.state.now) * (1 + 1e-9));
}

RC_GTEST_PROP(RevisePlaces, AfterAnyNewsTheRestIsValid, ()) {
    expect_valid_after_any_news(any_places_underway(12));
}

// An ambulance for each of two places, one behind a wall that an aircraft opens.
Underway from_the_hospital(double unreached) {
    const Map map = map_from_ascii(R"(
        ......a....
        ......a....
        ......a....
        ......a....
        ......a....
        ...........)");
    Mission mission{{vehicle("near", {0, 1}, {3, 1}), vehicle("far", {0, 1}, {9, 1}), aircraft("air", {0, 0})}};
    mission.rules.removals = 1;
    mission.rules.objective = Objective::flowtime;
    mission.rules.collisions = false;
    mission.rules.unreached = unreached;
    mission.rules.breach_time.per_obstacle = 1;
    mission.agents[2].weight = 0;
    Underway drawn{map, mission, Planner().plan(map, mission)};
    drawn.state.sequence = 1;
    return drawn;
}

double counted(const Plan& plan) {
    return plan.after.flowtime.value_or(0);
}

TEST(RevisePlaces, OneThatHasArrivedCountsFromThen) {
    Underway old = from_the_hospital(40);
    ASSERT_EQ(old.plan.breaches.size(), 1U);
    EXPECT_DOUBLE_EQ(counted(old.plan), 3 + 10);
    old.state.now = old.plan.breaches[0].cleared_at;
    old.state.failed = {{old.plan.breaches[0].obstacle, old.state.now}};
    ASSERT_GT(old.state.now, 3);
    Planner planner;
    const Revision next = revise(planner, old.map, old.mission, old.plan, old.state);
    EXPECT_EQ(next.status, RevisionStatus::revised);
    EXPECT_EQ(revision_faults(old, next), "");
    EXPECT_TRUE(next.plan.agents[1].reached);
    EXPECT_DOUBLE_EQ(counted(next.plan), 3 + next.plan.agents[1].path.back().t);
}

TEST(RevisePlaces, OneThatIsFreeTooLateCountsFromThen) {
    Underway old = from_the_hospital(14);
    old.state.now = 12.5;
    old.state.agents = {{.id = "far", .passed = 1, .at = Point(0.5, 1)}};
    Planner planner;
    const Revision next = revise(planner, old.map, old.mission, old.plan, old.state);
    ASSERT_EQ(next.plan.status, PlanStatus::solved);
    EXPECT_EQ(revision_faults(old, next), "");
    // It is on its way to its next bend, its goal.
    EXPECT_TRUE(next.plan.agents[1].reached);
    EXPECT_DOUBLE_EQ(counted(next.plan), 3 + 12.5 + 8.5);
}

TEST(RevisePlaces, OneThatHasNotLeftBeforeItIsTooLateIsLeft) {
    Underway old = from_the_hospital(14);
    old.state.now = 14.5;
    old.state.agents = {{.id = "far", .passed = 0, .at = Point(0, 1)}};
    Planner planner;
    const Revision next = revise(planner, old.map, old.mission, old.plan, old.state);
    ASSERT_EQ(next.plan.status, PlanStatus::solved);
    EXPECT_EQ(revision_faults(old, next), "");
    EXPECT_FALSE(next.plan.agents[1].reached);
    EXPECT_DOUBLE_EQ(next.plan.agents[1].path.back().t, 14.5);
}

TEST(RevisePlaces, OneThatHasStoppedBlocksNobody) {
    Underway old = from_the_hospital(40);
    old.state.now = 1;
    old.state.agents = {{.id = "near", .passed = 0, .at = Point(1, 1), .doing = Doing::stopped}};
    Planner planner;
    const Revision next = revise(planner, old.map, old.mission, old.plan, old.state);
    ASSERT_EQ(next.plan.status, PlanStatus::solved);
    EXPECT_EQ(revision_faults(old, next), "");
    EXPECT_TRUE(next.plan.revised->found.empty());
    EXPECT_DOUBLE_EQ(counted(next.plan), 10);
}

}  // namespace
}  // namespace waybreaker
