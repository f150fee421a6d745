// Aircraft under way whose battery ends.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "ascii_map.hpp"
#include "checked_plan.hpp"
#include "input_error.hpp"
#include "live/underway.hpp"
#include "waybreaker/revise.hpp"

namespace waybreaker {
namespace {

RC_GTEST_PROP(ReviseWithBatteries, WithoutNewsIsNoWorse, ()) {
    const Underway old = any_underway(14, false, true);
    Planner planner;
    const double reaction = *rc::gen::element(0.0, 0.0, 1.5);
    const Revision next = revise(planner, old.map, old.mission, old.plan, old.state, reaction);
    RC_CLASSIFY(next.mission.limits_flights());
    const auto recharges = [](const Itinerary& agent) { return !agent.recharges.empty(); };
    RC_CLASSIFY(std::ranges::any_of(old.plan.agents, recharges));
    RC_ASSERT(next.plan.status == PlanStatus::solved);
    RC_ASSERT(revision_faults(old, next) == "");
    if (old.mission.rules.objective == Objective::flowtime) return;
    const auto reached = [&](const Plan& plan) { return *value(plan.after, old.mission.rules.objective); };
    // Aircraft that are home already may fly again, so they count as home no earlier than that.
    RC_ASSERT(reached(next.plan) <= std::max(reached(old.plan), old.state.now + reaction) * (1 + 1e-9));
}

// Who is so late, or so far off, that its battery does not bring it home is an error that names it.
RC_GTEST_PROP(ReviseWithBatteries, AfterAnyNewsTheRestIsValid, ()) {
    try {
        expect_valid_after_any_news(any_underway(14, *rc::gen::arbitrary<bool>(), true));
    } catch (const InputError& error) {
        RC_ASSERT(error.error().detail.find("report it as lost") != std::string::npos);
    }
}

// An aircraft flies out to a long wall and back: 8 cells there, 8 home.
Underway out_and_back(double range, double reserve) {
    std::vector<std::string> rows(20, ".........A...");
    rows.back() = ".............";
    const Map map = Map::from_rows(rows);
    Mission mission = ground_and_air({8, 1}, {12, 1});
    Agent& air = mission.agents[1];
    air.start = air.goal = {0, 1};
    air.range = range;
    air.reserve = reserve;
    mission.rules.removals = 1;
    mission.rules.objective = Objective::ground_makespan;
    return {map, mission, Planner().plan(map, mission), {.sequence = 1, .now = 4}};
}

Revision revised(const Underway& old) {
    Planner planner;
    Revision next = revise(planner, old.map, old.mission, old.plan, old.state);
    EXPECT_EQ(revision_faults(old, next), "");
    return next;
}

TEST(ReviseWithBatteries, WhatIsFlownIsGone) {
    const Underway old = out_and_back(20, 0.2);
    ASSERT_EQ(old.plan.breaches.size(), 1U);
    const Revision next = revised(old);
    ASSERT_EQ(next.status, RevisionStatus::kept);
    EXPECT_DOUBLE_EQ(next.mission.agents[1].flown, 4);
    EXPECT_DOUBLE_EQ(next.mission.agents[1].reserve, 0.2);
    // A report knows better than the plan.
    Underway tired = out_and_back(21, 0);
    tired.state.agents = {{.id = "air", .passed = 0, .at = Point(4, 1), .flown = 6}};
    EXPECT_DOUBLE_EQ(revised(tired).mission.agents[1].flown, 6);
    EXPECT_EQ(revised(tired).plan.breaches.size(), 1U);
    tired.mission.agents[1].range = 17;
    const Revision back = revised(tired);
    EXPECT_TRUE(back.plan.breaches.empty());
    EXPECT_DOUBLE_EQ(back.plan.agents[1].path.back().t, 8);
}

TEST(ReviseWithBatteries, TheReserveBringsHomeWhoIsLate) {
    Underway old = out_and_back(20, 0.2);
    old.state.now = 12;
    old.state.agents = {{.id = "air", .passed = 0, .at = Point(6, 1)}};
    const Revision next = revised(old);
    ASSERT_EQ(next.plan.status, PlanStatus::solved);
    EXPECT_TRUE(next.plan.breaches.empty());
    EXPECT_DOUBLE_EQ(next.mission.agents[1].flown, 12);
    EXPECT_DOUBLE_EQ(next.mission.agents[1].reserve, 0.1);
    EXPECT_DOUBLE_EQ(next.plan.agents[1].path.back().t, 18);
    // It is no use to say that it has flown less, has a larger battery, or may use its reserve for anything else.
    const auto is_caught = [&](auto&& lie) {
        Revision other = next;
        lie(other);
        return revision_faults(old, other) != "";
    };
    EXPECT_TRUE(is_caught([](Revision& lie) { lie.mission.agents[1].flown = 8; }));
    EXPECT_TRUE(is_caught([](Revision& lie) { lie.mission.agents[1].range = 25; }));
    EXPECT_TRUE(is_caught([](Revision& lie) {
        lie.mission.agents[1].reserve = 0;
        lie.plan.agents[1].path.back().t += 1;
        lie.plan.agents[1].path.insert(lie.plan.agents[1].path.begin() + 1, {6.5, 1, 12.5});
    }));
}

TEST(ReviseWithBatteries, WhoCannotComeHomeIsAnError) {
    Underway old = out_and_back(20, 0.2);
    old.state.now = 15;
    old.state.agents = {{.id = "air", .passed = 0, .at = Point(6, 1)}};
    Planner planner;
    const auto error = [&] {
        return input_error([&] { (void)revise(planner, old.map, old.mission, old.plan, old.state); });
    };
    EXPECT_EQ(error(),
              "the air agent can still fly 5 cells; from where it is to its goal it is 6: send it to a nearer goal, or "
              "report it as lost");
    old.state.agents.front().goal = Cell{2, 1};
    EXPECT_EQ(error(), "");
    old.state.agents.front() = {.id = "air", .passed = 0, .doing = Doing::lost};
    EXPECT_EQ(error(), "");
    old.state.agents = {{.id = "ground", .passed = 0, .flown = 3}};
    EXPECT_EQ(error(), "agent ground drives, and is said to have flown");
}

// At home, it does not matter that its battery is empty; it flies no more.
TEST(ReviseWithBatteries, WhoIsHomeMayHaveUsedAllOfIt) {
    Underway old = out_and_back(20, 0);
    old.state.now = 30;
    old.state.agents = {{.id = "ground", .passed = 0, .at = Point(8, 1), .doing = Doing::waiting},
                        {.id = "air", .passed = old.plan.agents[1].path.size() - 1, .at = Point(0, 1), .flown = 25}};
    old.state.failed = {{old.plan.breaches.front().obstacle, 20}};
    old.mission.rules.retries = 1;
    const Revision next = revised(old);
    ASSERT_EQ(next.plan.status, PlanStatus::solved);
    EXPECT_TRUE(next.plan.breaches.empty());
    EXPECT_DOUBLE_EQ(next.mission.agents[1].flown, 20);
}

// Late at its start, it has not flown yet.
TEST(ReviseWithBatteries, WhoHasNotTakenOffHasAllOfIt) {
    Underway old = out_and_back(16, 0);
    old.state.agents = {{.id = "air", .passed = 0, .at = Point(0, 1), .doing = Doing::waiting}};
    const Revision next = revised(old);
    EXPECT_DOUBLE_EQ(next.mission.agents[1].flown, 0);
    EXPECT_EQ(next.plan.breaches.size(), 1U);
}

// It has flown since it began to breach from where it starts.
TEST(ReviseWithBatteries, WhoBreachesFromItsStartFlies) {
    Underway old{map_from_ascii(R"(
        ....#...
        ....#...
        ....#...)"),
                 {}};
    old.mission.agents = {vehicle("ground", {0, 1}, {7, 1}), aircraft("air", {3, 1})};
    old.mission.agents[1].range = 20;
    old.mission.rules.removals = 1;
    old.mission.rules.breach_time.per_obstacle = 6;
    old.plan = Planner().plan(old.map, old.mission);
    ASSERT_EQ(old.plan.breaches.size(), 1U);
    ASSERT_EQ(old.plan.breaches.front().at, (Cell{3, 1}));
    old.state = {.sequence = 1, .now = 3, .opened = {{old.plan.breaches.front().obstacle, 8}}};
    EXPECT_DOUBLE_EQ(revised(old).mission.agents[1].flown, 8);
}

}  // namespace
}  // namespace waybreaker
