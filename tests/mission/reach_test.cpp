// Reach of missions with many places: by hand, by laws on random maps, and against the arrivals of plans.
#include "mission/reach.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "ascii_map.hpp"
#include "crossing/crossing_case.hpp"
#include "waybreaker/planner.hpp"

namespace waybreaker {
namespace {

constexpr float no_way = std::numeric_limits<float>::infinity();
constexpr float rounding = 1e-3F;

// Vehicles between a hub and two places, and a plan that has opened obstacles at certain times.
struct Opened {
    Map map;
    Mission mission = {};
    Plan plan = {};

    Opened(std::string_view picture, bool inbound, const std::vector<std::pair<char, double>>& openings)
        : map(map_from_ascii(picture)) {
        const Cell hub = mark_in_ascii(picture, 'S');
        const Cell place = mark_in_ascii(picture, 'G');
        for (const Cell at : {place, hub}) {
            const std::string id = std::to_string(mission.agents.size());
            mission.agents.push_back(inbound ? vehicle(id, at, hub) : vehicle(id, hub, at));
        }
        mission.rules.collisions = false;
        plan.status = PlanStatus::solved;
        for (const auto& [letter, time] : openings)
            plan.breaches.push_back({.obstacle = map.obstacle_at(mark_in_ascii(picture, letter)), .cleared_at = time});
    }
    float at(const std::vector<float>& times, Cell c) const {
        return times[std::size_t(c.y) * std::size_t(map.width()) + std::size_t(c.x)];
    }
};

TEST(Reach, WaitsWhereTheWayIsNotOpenYet) {
    const Opened world("S..a..G", false, {{'a', 10}});
    const auto reach = reach_of(world.map, world.mission, world.plan);
    ASSERT_TRUE(reach);
    EXPECT_FALSE(reach->inbound);
    EXPECT_EQ(reach->hubs, std::vector<Cell>{(Cell{0, 0})});
    EXPECT_FLOAT_EQ(world.at(reach->before, {2, 0}), 2);
    EXPECT_EQ(world.at(reach->before, {3, 0}), no_way);
    EXPECT_EQ(world.at(reach->before, {6, 0}), no_way);
    EXPECT_FLOAT_EQ(world.at(reach->after, {2, 0}), 2);
    EXPECT_FLOAT_EQ(world.at(reach->after, {4, 0}), 12);  // touches at 2
    EXPECT_FLOAT_EQ(world.at(reach->after, {6, 0}), 14);
}

TEST(Reach, CountsTheWaitBeforeAWayToTheHub) {
    const Opened world("S..a..G", true, {{'a', 10}});
    const auto reach = reach_of(world.map, world.mission, world.plan);
    ASSERT_TRUE(reach);
    EXPECT_TRUE(reach->inbound);
    EXPECT_FLOAT_EQ(world.at(reach->after, {2, 0}), 2);
    EXPECT_FLOAT_EQ(world.at(reach->after, {4, 0}), 14);  // there is no way on before 10
    EXPECT_FLOAT_EQ(world.at(reach->after, {6, 0}), 14);
    const Opened early("S..a..G", true, {{'a', 1}});
    const auto unhindered = reach_of(early.map, early.mission, early.plan);
    EXPECT_FLOAT_EQ(early.at(unhindered->after, {6, 0}), 6);
}

TEST(Reach, StandsForRubbleAfterTheOpening) {
    for (const bool inbound : {false, true}) {
        Opened world("S..a..G", inbound, {{'a', 10}});
        world.mission.rules.rubble = 5;
        const auto reach = reach_of(world.map, world.mission, world.plan);
        EXPECT_FLOAT_EQ(world.at(reach->after, {2, 0}), 2);
        EXPECT_FLOAT_EQ(world.at(reach->after, {4, 0}), inbound ? 19 : 17);
        EXPECT_FLOAT_EQ(world.at(reach->after, {6, 0}), 19);
        Opened early("S..a..G", inbound, {{'a', 0}});
        early.mission.rules.rubble = 5;
        const auto unhindered = reach_of(early.map, early.mission, early.plan);
        EXPECT_FLOAT_EQ(early.at(unhindered->after, {6, 0}), 11);
    }
}

TEST(Reach, GoesRoundWhatOpensLateRatherThanWait) {
    const Opened world(R"(
        .....c...
        S.a..c..G
        ..a..c...)",
                       false, {{'a', 40}, {'c', 41}});
    const auto reach = reach_of(world.map, world.mission, world.plan);
    // It stands before c long before a opens; from there it is 4 to the place.
    EXPECT_NEAR(world.at(reach->after, {8, 1}), 45, 0.2);
}

TEST(Reach, KnowsTheRules) {
    Opened world("S..a..G", false, {{'a', 10}});
    world.mission.rules.timing = Timing::ignore;
    EXPECT_FLOAT_EQ(world.at(reach_of(world.map, world.mission, world.plan)->after, {6, 0}), 6);
    world.mission.rules.timing = Timing::enforce;
    for (Agent& agent : world.mission.agents) {
        agent.speed = 2;
        agent.ready_at = 3;
    }
    EXPECT_FLOAT_EQ(world.at(reach_of(world.map, world.mission, world.plan)->before, {2, 0}), 4);
    EXPECT_FLOAT_EQ(world.at(reach_of(world.map, world.mission, world.plan)->after, {6, 0}), 12);
    world.mission.rules.opened = {{world.plan.breaches.front().obstacle, 7}};
    world.plan.breaches.clear();
    EXPECT_FLOAT_EQ(world.at(reach_of(world.map, world.mission, world.plan)->before, {6, 0}), 9);
}

TEST(Reach, IsThatOfVehiclesWhichAreAlike) {
    const Opened world("S..a..G", false, {{'a', 10}});
    const auto has_reach = [&](auto change) {
        Opened other = world;
        change(other);
        return reach_of(other.map, other.mission, other.plan).has_value();
    };
    EXPECT_TRUE(has_reach([](Opened&) {}));
    EXPECT_FALSE(has_reach([](Opened& other) { other.mission.rules.collisions = true; }));
    EXPECT_FALSE(has_reach([](Opened& other) { other.plan.status = PlanStatus::no_plan; }));
    EXPECT_FALSE(has_reach([](Opened& other) { other.mission.agents[0].speed = 2; }));
    EXPECT_FALSE(has_reach([](Opened& other) { other.mission.agents[0].ready_at = 2; }));
    EXPECT_FALSE(has_reach([](Opened& other) { other.mission.agents[0].body.radius = 0.4; }));
    EXPECT_FALSE(has_reach([](Opened& other) { other.mission.agents[0].start = {1, 0}; }));
}

// A hub, places anywhere, an aircraft.
struct AnyPlaces {
    Map map;
    Mission mission;
};

AnyPlaces any_places(bool inbound) {
    AnyPlaces made{random_label_map(9), {}};
    const PlainMap plain = waybreaker::plain(made.map);
    const Cell hub = any_free_cell(plain);
    for (int i = *number(2, 4); i > 0; --i) {
        const Cell place = any_free_cell(plain);
        const std::string id = std::to_string(i);
        made.mission.agents.push_back(inbound ? vehicle(id, place, hub) : vehicle(id, hub, place));
    }
    made.mission.agents.push_back(aircraft("air", any_free_cell(plain)));
    Rules& rules = made.mission.rules;
    rules.removals = *number(0, 3);
    rules.objective = Objective::flowtime;
    rules.breach_time.per_obstacle = *number(0, 6);
    rules.collisions = false;
    rules.unreached = 100;
    return made;
}

RC_GTEST_PROP(Reach, IsWhenThePlanIsThere, ()) {
    const bool inbound = *number(0, 1) == 1;
    const AnyPlaces world = any_places(inbound);
    const Plan plan = Planner().plan(world.map, world.mission);
    const auto reach = reach_of(world.map, world.mission, plan);
    RC_PRE(reach.has_value());
    double opened = 0;  // cells
    for (const Breach& breach : plan.breaches) opened += breach.cells;
    for (std::size_t i = 0; i < plan.agents.size(); ++i) {
        const Agent& agent = world.mission.agents[i];
        if (agent.kind == AgentKind::air) continue;
        const Cell place = inbound ? agent.start : agent.goal;
        const float time = reach->after[std::size_t(place.y) * std::size_t(world.map.width()) + std::size_t(place.x)];
        RC_ASSERT(plan.agents[i].reached == (time <= 100));
        if (!plan.agents[i].reached) continue;
        // Theta* is hardly ever longer; but who has to wait may do so where the rest of the way is shorter.
        const double arrival = plan.agents[i].path.back().t;
        RC_ASSERT(time >= arrival - rounding);
        RC_ASSERT(time <= 1.1 * arrival + opened);
    }
}

RC_GTEST_PROP(Reach, IsNoSoonerWithLaterOpenings, ()) {
    const AnyPlaces world = any_places(*number(0, 1) == 1);
    Plan plan;
    plan.status = PlanStatus::solved;
    for (const Obstacle& obstacle : world.map.obstacles()) {
        if (plan.breaches.size() < 3)
            plan.breaches.push_back({.obstacle = obstacle.id, .cleared_at = double(*number(1, 20))});
    }
    const auto reach = reach_of(world.map, world.mission, plan);
    RC_PRE(reach.has_value());
    for (std::size_t i = 0; i < reach->after.size(); ++i) RC_ASSERT(reach->after[i] <= reach->before[i]);
    if (plan.breaches.empty()) return;
    plan.breaches[std::size_t(*number(0, int(plan.breaches.size()) - 1))].cleared_at += 5;
    const auto later = reach_of(world.map, world.mission, plan);
    for (std::size_t i = 0; i < reach->after.size(); ++i) RC_ASSERT(reach->after[i] <= later->after[i] + rounding);
}

}  // namespace
}  // namespace waybreaker
