// Revisions of random missions under way: valid plans, that go on from where everybody is, and never end later than
// what is still possible.
#include "waybreaker/revise.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "ascii_map.hpp"
#include "checked_plan.hpp"
#include "input_error.hpp"
#include "live/underway.hpp"

namespace waybreaker {
namespace {

double reached(const Plan& plan, const Mission& mission) {
    return *value(plan.after, mission.rules.objective);
}

RC_GTEST_PROP(Revise, WithoutNewsIsNoWorse, ()) {
    const Underway old = any_underway(14);
    Planner planner;
    const double reaction = *rc::gen::element(0.0, 0.0, 1.5);
    const Revision next = revise(planner, old.map, old.mission, old.plan, old.state, reaction);
    RC_ASSERT(next.plan.status == PlanStatus::solved);
    RC_ASSERT(revision_faults(old, next) == "");
    // Aircraft that are home already may fly again, so they count as home no earlier than that.
    const double since = old.state.now + reaction;
    if (old.mission.rules.objective != Objective::flowtime) {
        RC_ASSERT(reached(next.plan, old.mission) <= std::max(reached(old.plan, old.mission), since) * (1 + 1e-9));
    }
    if (next.status != RevisionStatus::kept) return;
    // The rest is the same to the byte.
    for (std::size_t i = 0; i < old.plan.agents.size(); ++i) {
        const std::vector<Waypoint>& was = old.plan.agents[i].path;
        const std::vector<Waypoint>& is = next.plan.agents[i].path;
        for (const Waypoint& p : was) {
            if (p.t > old.state.now) RC_ASSERT(std::ranges::find(is, p) != is.end());
        }
    }
}

// A breach fails when it is done.
Breach fail_a_breach(Underway& mission) {
    const std::vector<Breach>& planned = mission.plan.breaches;
    const Breach& failed = planned[std::size_t(*number(0, int(planned.size()) - 1))];
    mission.state.now = failed.cleared_at;
    mission.state.failed = {{failed.obstacle, failed.cleared_at}};
    return failed;
}

RC_GTEST_PROP(Revise, AReportTwiceIsAReportOnce, ()) {
    Underway old = any_underway(10);
    if (!old.plan.breaches.empty() && *number(0, 1) == 1) fail_a_breach(old);
    Planner planner;
    const Revision next = revise(planner, old.map, old.mission, old.plan, old.state);
    RC_PRE(next.plan.status == PlanStatus::solved);
    const Revision again = revise(planner, next.map, next.mission, next.plan, old.state);
    RC_ASSERT(again.status == RevisionStatus::unchanged);
    RC_ASSERT(again.plan.agents.size() == next.plan.agents.size());
    for (std::size_t i = 0; i < next.plan.agents.size(); ++i)
        RC_ASSERT(again.plan.agents[i].path == next.plan.agents[i].path);
}

RC_GTEST_PROP(Revise, AfterAFailedBreachTheRestIsValid, ()) {
    Underway old = any_underway(14);
    RC_PRE(!old.plan.breaches.empty());
    const Breach failed = fail_a_breach(old);
    Planner planner;
    const Revision next = revise(planner, old.map, old.mission, old.plan, old.state);
    RC_PRE(next.plan.status == PlanStatus::solved);
    RC_ASSERT(next.status == RevisionStatus::revised);
    RC_ASSERT(revision_faults(old, next) == "");
    const bool again =
        std::ranges::find(next.plan.breaches, failed.obstacle, &Breach::obstacle) != next.plan.breaches.end();
    if (old.mission.rules.retries == 0) RC_ASSERT(!again);
}

// Whatever is planned is valid.
RC_GTEST_PROP(Revise, AfterAnyNewsTheRestIsValid, ()) {
    expect_valid_after_any_news(any_underway(14));
}

TEST(Revise, WhatHasToGoIsTriedAgainAsOftenAsItMay) {
    const Map map = Map::from_rows({"..A..", "..A..", "....."});
    Mission mission = ground_and_air({0, 0}, {4, 0});
    mission.rules.breach_time.per_obstacle = 0.5;
    mission.rules.removals = 1;
    mission.rules.force = {{1}};
    for (const int retries : {0, 1}) {
        mission.rules.retries = retries;
        Planner planner;
        const Plan plan = planner.plan(map, mission);
        ASSERT_EQ(plan.breaches.size(), 1U);
        const State state{.sequence = 1,
                          .now = plan.breaches[0].cleared_at,
                          .failed = {{plan.breaches[0].obstacle, plan.breaches[0].cleared_at}}};
        const Revision next = revise(planner, map, mission, plan, state);
        EXPECT_EQ(next.status, RevisionStatus::revised) << "there is a way around";
        EXPECT_EQ(next.plan.breaches.size(), std::size_t(retries));
        EXPECT_EQ(next.mission.rules.force.size(), std::size_t(retries));
        EXPECT_EQ(next.mission.rules.protect.size(), std::size_t(1 - retries));
    }
}

// A rover before a wall, and an aircraft that is at its breach of it from 1.5 to 3.5.
Underway at_a_wall(double now) {
    const Map map = Map::from_rows({"....A....", "....A....", "....A....", "....A....", "........."});
    Mission mission = ground_and_air({0, 1}, {8, 1});
    mission.agents[1].speed = 2;
    mission.rules.removals = 1;
    mission.rules.breach_time.per_obstacle = 2;
    Underway old{map, mission, Planner().plan(map, mission)};
    EXPECT_EQ(old.plan.breaches.size(), 1U);
    EXPECT_EQ(old.plan.breaches[0].cleared_at, 3.5);
    old.state = {.sequence = 1, .now = now};
    return old;
}

TEST(Revise, ABreachThatWasLeftOffBeginsAgain) {
    const AgentState waits{.id = "air", .passed = 1, .doing = Doing::waiting};
    const AgentState is_away{.id = "air", .passed = 1, .at = Point(1, 1)};
    for (const AgentState& said : {waits, is_away}) {
        Underway old = at_a_wall(2.5);
        old.state.agents = {said, {.id = "ground", .passed = 0, .at = Point(1, 1), .doing = Doing::waiting}};
        Planner planner;
        const Revision next = revise(planner, old.map, old.mission, old.plan, old.state);
        EXPECT_TRUE(next.mission.rules.opened.empty());
        EXPECT_EQ(revision_faults(old, next), "");
        ASSERT_EQ(next.plan.breaches.size(), 1U);
        const double back = said.at ? 1 : 0;
        EXPECT_NEAR(next.plan.breaches[0].cleared_at, 2.5 + back + 2, 1e-9);
    }
}

TEST(Revise, WithoutAPlanTheRestIsStatedAsItIs) {
    Underway old = at_a_wall(2.5);
    old.state.agents = {{.id = "ground", .passed = 0, .doing = Doing::stopped}, {.id = "air", .passed = 1}};
    Planner planner;
    Revision next = revise(planner, old.map, old.mission, old.plan, old.state);
    EXPECT_EQ(next.status, RevisionStatus::no_plan);
    EXPECT_EQ(revision_faults(old, next), "");
    old = at_a_wall(0.5);
    old.state.agents = {{.id = "ground", .passed = 0, .doing = Doing::stopped},
                        {.id = "air", .passed = 0, .goal = Cell{0, 4}}};
    next = revise(planner, old.map, old.mission, old.plan, old.state);
    EXPECT_EQ(next.status, RevisionStatus::no_plan);
    EXPECT_EQ(revision_faults(old, next), "");
}

TEST(Revise, RefusesAFailureThatIsReportedTwiceAtOnce) {
    Underway old = at_a_wall(4);
    old.state.failed = {{ObstacleId{1}, 3.5}, {ObstacleId{1}, 3.9}};
    Planner planner;
    EXPECT_NE(input_error([&] {
                  (void)revise(planner, old.map, old.mission, old.plan, old.state);
              }).find("failed more than once"),
              std::string::npos);
}

TEST(Revise, RefusesStatesThatCannotBe) {
    const Map map = Map::from_rows({"..A..", "..A..", "..A.."});
    const Mission mission = ground_and_air({0, 1}, {4, 1});
    const Plan plan = Planner().plan(map, mission);
    Planner planner;
    const auto refused = [&](const State& state) {
        return input_error([&] { static_cast<void>(revise(planner, map, mission, plan, state)); });
    };
    EXPECT_EQ(refused({.sequence = 1, .agents = {{.id = "bus"}}}),
              "the state names agent bus, which the plan does not have");
    EXPECT_EQ(refused({.sequence = 1, .failed = {{{2}, 0}}}), "failed obstacle 2: the map has none of that id");
    EXPECT_EQ(refused({.sequence = 1, .agents = {{.id = "ground", .passed = 99}}}),
              "agent ground has passed point 99 of its path, which has " + std::to_string(plan.agents[0].path.size()) +
                  ", counted from 0");
    EXPECT_EQ(refused({.sequence = 1, .found = {{{{9, 9}}}}}), "cell 9,9 was found, and is off the map");
}

// What has opened late is rubble for as long as what has opened in time.
TEST(Revise, WhoMeetsRubbleTakesItsTimeAfterALateOpening) {
    Underway old{map_from_ascii(R"(
        .....#...
        .....#...
        .....#...)"),
                 {}};
    old.mission.agents = {vehicle("ground", {0, 1}, {8, 1}), aircraft("air", {0, 1})};
    old.mission.rules.removals = 1;
    old.mission.rules.rubble = 10;
    old.plan = Planner().plan(old.map, old.mission);
    ASSERT_EQ(old.plan.breaches.size(), 1U);
    const TimedOpening late{old.plan.breaches.front().obstacle, old.plan.breaches.front().cleared_at + 3};
    old.state = {.sequence = 1, .now = late.at, .opened = {late}};
    Planner planner;
    const Revision next = revise(planner, old.map, old.mission, old.plan, old.state, 0);
    ASSERT_EQ(next.plan.status, PlanStatus::solved);
    EXPECT_EQ(revision_faults(old, next), "");
}

}  // namespace
}  // namespace waybreaker
