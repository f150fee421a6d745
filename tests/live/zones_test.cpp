// Missions with zones under way.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "checked_plan.hpp"
#include "input_error.hpp"
#include "live/underway.hpp"
#include "waybreaker/revise.hpp"

namespace waybreaker {
namespace {

RC_GTEST_PROP(ReviseInZones, WithoutNewsIsNoWorse, ()) {
    const Underway old = any_underway(14, true);
    Planner planner;
    const double reaction = *rc::gen::element(0.0, 0.0, 1.5);
    const Revision next = revise(planner, old.map, old.mission, old.plan, old.state, reaction);
    RC_CLASSIFY(next.status == RevisionStatus::kept);
    RC_ASSERT(next.plan.status == PlanStatus::solved);
    RC_ASSERT(revision_faults(old, next) == "");
    if (old.mission.rules.objective == Objective::flowtime) return;
    const auto reached = [&](const Plan& plan) { return *value(plan.after, old.mission.rules.objective); };
    // Aircraft that are home already may fly again, so they count as home no earlier than that.
    RC_ASSERT(reached(next.plan) <= std::max(reached(old.plan), old.state.now + reaction) * (1 + 1e-9));
}

// An aircraft anywhere on the map, in a zone as well.
void report_off_course(Underway& mission) {
    for (const Itinerary& agent : mission.plan.agents) {
        if (agent.kind == AgentKind::ground || *number(0, 1) == 0) continue;
        auto said = std::ranges::find(mission.state.agents, agent.id, &AgentState::id);
        if (said == mission.state.agents.end())
            said = mission.state.agents.insert(said, {agent.id, agent.path.size() / 2});
        said->at = Point(*number(0, 10 * (mission.map.width() - 1)) / 10.0,
                         *number(0, 10 * (mission.map.height() - 1)) / 10.0);
    }
}

// After three rounds of news.
void expect_valid_after_news(Underway old) {
    Planner planner;
    for (int round = 1; round <= 3; ++round) {
        old.state.sequence = std::uint64_t(round);
        report_any_news(old);
        report_off_course(old);
        std::optional<Revision> next;
        try {
            next = revise(planner, old.map, old.mission, old.plan, old.state, *rc::gen::element(0.0, 1.0));
        } catch (const InputError& error) {
            // Where zones enclose an aircraft.
            RC_ASSERT(std::string(error.what()).find("the zones leave no way to fly") != std::string::npos);
            return;
        }
        RC_CLASSIFY(next->status == RevisionStatus::revised);
        RC_CLASSIFY(next->status == RevisionStatus::broken);
        if (next->plan.status != PlanStatus::solved) return;
        RC_ASSERT(revision_faults(old, *next) == "");
        const double since = old.state.now;
        old = {next->map, next->mission, next->plan, {}};
        old.state.now = since + *number(0, 6);
    }
}

RC_GTEST_PROP(ReviseInZones, AfterAnyNewsTheRestIsValid, ()) {
    expect_valid_after_news(any_underway(14, true));
}

RC_GTEST_PROP(ReviseInZones, TheSameOfZonesThatHoldForATime, ()) {
    expect_valid_after_news(any_windowed_underway(14));
}

RC_GTEST_PROP(ReviseInZones, WithoutNewsZonesThatHoldForATimeStayKept, ()) {
    const Underway old = any_windowed_underway(14);
    Planner planner;
    const Revision next = revise(planner, old.map, old.mission, old.plan, old.state);
    RC_ASSERT(next.plan.status == PlanStatus::solved);
    RC_ASSERT(revision_faults(old, next) == "");
}

// A rover behind a wall, and an aircraft whose straight way to it leads through a zone.
Underway round_a_zone() {
    const Map map = Map::from_rows({
        "..........A....",
        "..........A....",
        "..........A....",
        "..........A....",
        "..........A....",
        "..........A....",
        "..........A....",
    });
    Mission mission = ground_and_air({8, 6}, {14, 6});
    Agent& air = mission.agents[1];
    air.start = air.goal = {0, 3};
    mission.rules.removals = 1;
    mission.rules.zones = {{.polygon = {{{3, 1}, {6, 1}, {6, 4}, {3, 4}}}, .name = "helipad"}};
    Underway old{map, mission, Planner().plan(map, mission)};
    old.state = {.sequence = 1, .now = 1};
    return old;
}

const Itinerary& aircraft_of(const Plan& plan) {
    return *std::ranges::find(plan.agents, AgentKind::air, &Itinerary::kind);
}

TEST(ReviseInZones, AnAircraftFliesOutOfAZoneThatHoldsNowAndOnWhereItDoesNotYet) {
    for (const bool holds : {true, false}) {
        Underway old = round_a_zone();
        Zone& zone = old.mission.rules.zones.front();
        zone.from = holds ? 0 : 20;
        zone.until = 50;
        old.plan = Planner().plan(old.map, old.mission);
        ASSERT_EQ(old.plan.status, PlanStatus::solved);
        old.state.agents = {{.id = "air", .passed = 0, .at = Point(3.75, 3)}};
        Planner planner;
        const Revision next = revise(planner, old.map, old.mission, old.plan, old.state);
        ASSERT_EQ(next.plan.status, PlanStatus::solved);
        EXPECT_EQ(revision_faults(old, next), "");
        const std::vector<Waypoint>& path = aircraft_of(next.plan).path;
        EXPECT_EQ(path[1] == Waypoint(3, 3, 1.75), holds);
    }
}

// It was to breach before the zone over the obstacle begins.
TEST(ReviseInZones, WhatALateAircraftCannotGetToAnyMoreIsNotOpened) {
    Underway old = round_a_zone();
    old.mission.rules.zones = {{.polygon = {{{7, -1}, {13, -1}, {13, 7}, {7, 7}}}, .name = "helipad", .from = 20}};
    old.plan = Planner().plan(old.map, old.mission);
    ASSERT_EQ(old.plan.breaches.size(), 1U);
    ASSERT_LT(old.plan.breaches[0].cleared_at, 20);
    old.state.now = 20.5;
    old.state.agents = {{.id = "air", .passed = 0, .at = Point(2, 3)},
                        {.id = "ground", .passed = 0, .doing = Doing::waiting}};
    Planner planner;
    const Revision next = revise(planner, old.map, old.mission, old.plan, old.state);
    EXPECT_TRUE(next.mission.rules.opened.empty());
    EXPECT_EQ(next.status, RevisionStatus::no_plan);
}

// Of the cells outside, (3, 3) is the nearest.
TEST(ReviseInZones, AnAircraftFoundInAZoneFliesStraightOut) {
    Underway old = round_a_zone();
    ASSERT_EQ(old.plan.status, PlanStatus::solved);
    old.state.agents = {{.id = "air", .passed = 0, .at = Point(3.75, 3)}};
    Planner planner;
    const Revision next = revise(planner, old.map, old.mission, old.plan, old.state);
    ASSERT_EQ(next.status, RevisionStatus::revised);
    EXPECT_EQ(revision_faults(old, next), "");
    const std::vector<Waypoint>& path = aircraft_of(next.plan).path;
    EXPECT_EQ(path[0], Waypoint(3.75, 3, 1));
    EXPECT_EQ(path[1], Waypoint(3, 3, 1.75));
    // What comes later may not lead through it.
    Plan through = next.plan;
    std::vector<Waypoint>& bent = through.agents[1].path;
    ASSERT_EQ(through.agents[1].kind, AgentKind::air);
    bent.insert(bent.begin() + 2, {{4.5, 2.5, bent[1].t + 0.1}, {3, 3, bent[1].t + 0.2}});
    EXPECT_NE(plan_faults(next.map, next.mission, through).find("flies in zone helipad"), std::string::npos);

    // On its way out it goes on.
    Underway later{next.map, next.mission, next.plan, {.sequence = 2, .now = 1.5}};
    const Revision again = revise(planner, later.map, later.mission, later.plan, later.state);
    ASSERT_EQ(again.plan.status, PlanStatus::solved);
    EXPECT_EQ(revision_faults(later, again), "");
    EXPECT_EQ(aircraft_of(again.plan).path[1], Waypoint(3, 3, 1.75));
}

// It takes two units of time until it knows; until then it is on its way to the corner at (3, 4).
TEST(ReviseInZones, AnAircraftOffItsPathFliesRoundOnItsWayBack) {
    Underway old = round_a_zone();
    old.state.agents = {{.id = "air", .passed = 0, .at = Point(2.5, 1.5)}};
    const std::vector<Waypoint>& planned = aircraft_of(old.plan).path;
    old.state.agents.front().passed = 1;
    ASSERT_EQ(Point(planned[2].x, planned[2].y), Point(6, 4));
    Planner planner;
    const Revision next = revise(planner, old.map, old.mission, old.plan, old.state, 2);
    ASSERT_EQ(next.plan.status, PlanStatus::solved);
    EXPECT_EQ(revision_faults(old, next), "");
    const std::vector<Waypoint>& path = aircraft_of(next.plan).path;
    EXPECT_NEAR(path[1].x, 2.5 + 1 / std::sqrt(6.5), 1e-9);
    EXPECT_NEAR(path[1].y, 1.5 + 5 / std::sqrt(6.5), 1e-9);
}

TEST(ReviseInZones, AnAircraftThatZonesEncloseIsAnError) {
    Underway old = round_a_zone();
    old.mission.rules.zones.front().polygon.push_back({{4, 2}, {5, 2}, {5, 3}, {4, 3}});
    old.state.agents = {{.id = "air", .passed = 0, .at = Point(4.5, 2.5)}};
    Planner planner;
    for (const double reaction : {0, 1}) {
        EXPECT_EQ(
            input_error(
                [&] { static_cast<void>(revise(planner, old.map, old.mission, old.plan, old.state, reaction)); }),
            "the zones leave no way to fly from the air agent's start 4.5,2.5 to its goal 0,3; leave one of them out");
    }
}

TEST(ReviseInZones, AVehicleInAZoneMustStop) {
    Underway old = round_a_zone();
    old.mission.rules.zones = {{ZoneKind::keep_out, {{{5, 1}, {7, 1}, {7, 3}, {5, 3}}}, "yard"}};
    old.plan = Planner().plan(old.map, old.mission);
    old.state.agents = {{.id = "ground", .passed = 0, .at = Point(6, 2)}};
    Planner planner;
    const Revision next = revise(planner, old.map, old.mission, old.plan, old.state);
    EXPECT_EQ(next.status, RevisionStatus::broken);
    ASSERT_EQ(next.plan.revised->halts.size(), 1U);
    EXPECT_EQ(next.plan.revised->halts.front().agent, "ground");
    EXPECT_EQ(next.plan.revised->halts.front().by, 1);
}

TEST(ReviseInZones, AZoneForgetsWhoIsLost) {
    Underway old = round_a_zone();
    Agent second = old.mission.agents[1];
    second.id = "second";
    old.mission.agents.push_back(second);
    old.mission.rules.zones.front().agents = {"air", "second"};
    old.plan = Planner().plan(old.map, old.mission);
    old.state.agents = {{.id = "air", .passed = 0, .doing = Doing::lost}};
    Planner planner;
    const Revision next = revise(planner, old.map, old.mission, old.plan, old.state);
    ASSERT_EQ(next.plan.status, PlanStatus::solved);
    EXPECT_EQ(revision_faults(old, next), "");
    ASSERT_EQ(next.mission.rules.zones.size(), 1U);
    EXPECT_EQ(next.mission.rules.zones.front().agents, std::vector<std::string>{"second"});

    Underway later{next.map, next.mission, next.plan, {.sequence = 2, .now = 2}};
    later.state.agents = {{.id = "second", .passed = 0, .doing = Doing::lost}};
    const Revision last = revise(planner, later.map, later.mission, later.plan, later.state);
    EXPECT_TRUE(last.mission.rules.zones.empty());
}

// What falls by itself opens the way, but not through a zone.
TEST(ReviseInZones, WhatOpensInAZoneStaysClosedThere) {
    Underway old = round_a_zone();
    old.mission.rules.zones = {{ZoneKind::keep_out, {{{9.5, 2.5}, {10.5, 2.5}, {10.5, 6.5}, {9.5, 6.5}}}, "pit"}};
    old.mission.rules.removals = 0;
    Mission open = old.mission;
    open.rules.opened = {{{1}, 0}};
    Planner planner;
    const Plan at_once = planner.plan(old.map, open);
    open.rules.opened = {{{1}, 2}};
    const Plan late = planner.plan(old.map, open);
    for (const Plan& plan : {at_once, late}) {
        ASSERT_EQ(plan.status, PlanStatus::solved);
        EXPECT_EQ(plan_faults(old.map, open, plan), "");
        EXPECT_GT(*plan.after.ground().length, 8);  // round the pit
    }
}

// Nor need an aircraft get there; of several neither.
TEST(ReviseInZones, WhatOpensByItselfMayBeOutOfReach) {
    Underway old = round_a_zone();
    old.mission.rules.zones = {{ZoneKind::no_fly, {{{8.5, -0.5}, {14.5, -0.5}, {14.5, 6.5}, {8.5, 6.5}}}, "city", {}}};
    Agent second = old.mission.agents[1];
    second.id = "second";
    for (int aircraft = 1; aircraft <= 2; ++aircraft) {
        old.mission.rules.opened = {};
        EXPECT_EQ(Planner().plan(old.map, old.mission).status, PlanStatus::no_plan);
        old.mission.rules.opened = {{{1}, 2}};
        const Plan plan = Planner().plan(old.map, old.mission);
        ASSERT_EQ(plan.status, PlanStatus::solved);
        EXPECT_EQ(plan_faults(old.map, old.mission, plan), "");
        EXPECT_GT(*plan.after.ground_makespan, 6);  // the way is 6 long, and it waits
        EXPECT_LE(*plan.after.ground_makespan, 8);
        old.mission.agents.push_back(second);
    }
}

TEST(ReviseInZones, PlanBKeepsOutOfZones) {
    Underway old = round_a_zone();
    old.mission.rules.retries = 1;
    Planner planner;
    const Plan plan = with_plan_b(planner, old.map, old.mission, old.plan);
    ASSERT_EQ(plan.breaches.size(), 1U);
    ASSERT_TRUE(plan.breaches.front().if_failed);
    EXPECT_TRUE(std::isfinite(plan.breaches.front().if_failed->objective));
}

}  // namespace
}  // namespace waybreaker
