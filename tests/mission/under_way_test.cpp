// Missions of agents that are under way already, and of obstacles that open by themselves.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "all_plans.hpp"
#include "ascii_map.hpp"
#include "checked_plan.hpp"
#include "input_error.hpp"
#include "mission/any_world.hpp"
#include "waybreaker/map_edit.hpp"
#include "waybreaker/planner.hpp"

namespace waybreaker {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double after_all = 1e6;  // nobody is on the way that long

double reached(const World& world, const Plan& plan) {
    return value(plan.after, world.mission.rules.objective).value_or(infinity);
}

// Aircraft that take off later, and anywhere; agents on an approach.
void set_out(World& world) {
    const double right = world.map.width() - 1;
    const double down = world.map.height() - 1;
    for (Agent& agent : world.mission.agents) {
        if (agent.kind == AgentKind::air) {
            agent.ready_at = *rc::gen::element(0.0, 0.0, 1.5, 6.0);
            if (*rc::gen::arbitrary<bool>()) {
                const double x = *rc::gen::element(-0.4, 0.0, 0.25);
                const double y = *rc::gen::element(-0.1, 0.3);
                agent.from = Point(std::clamp(agent.start.x + x, 0.0, right), std::clamp(agent.start.y + y, 0.0, down));
            }
        }
        if (agent.ready_at > 0 && *rc::gen::arbitrary<bool>()) {
            const Point start = agent.begin();
            agent.approach = {{start.x, start.y, agent.ready_at / 2}, {start.x, start.y, agent.ready_at}};
            if (*rc::gen::arbitrary<bool>()) agent.approach.erase(agent.approach.begin());
        }
    }
}

void open_some(World& world) {
    for (const Obstacle& obstacle : world.map.obstacles()) {
        const bool forced = std::ranges::count(world.mission.rules.force, obstacle.id) > 0;
        if (forced || *number(0, 1) == 0) continue;
        const double at = *rc::gen::element(0.0, 1.0, 4.0, 9.0, 30.0, after_all);
        world.mission.rules.opened.push_back({obstacle.id, at});
    }
}

void add_aircraft(World& world) {
    const int more = *number(0, 1);
    for (int i = 0; i < more; ++i) {
        Agent agent = world.mission.agents[1];
        agent.id += std::to_string(i);
        agent.start = {*number(0, world.map.width() - 1), *number(0, world.map.height() - 1)};
        world.mission.agents.push_back(agent);
    }
}

World any_world_under_way() {
    World world = any_world();
    add_aircraft(world);
    set_out(world);
    open_some(world);
    return world;
}

RC_GTEST_PROP(UnderWay, NoPlanIsBelowTheBoundAndNoneBeatsAllPlans, ()) {
    const World world = any_world_under_way();
    const Plan plan = Planner().plan(world.map, world.mission);
    RC_ASSERT(plan_faults(world.map, world.mission, plan) == "");
    const double best = AllPlans(world.map, world.mission).best();
    if (plan.status != PlanStatus::solved) {
        RC_ASSERT(best == infinity);
        return;
    }
    RC_LOG() << "reached " << reached(world, plan) << ", best " << best << ", bound " << *plan.bound << "\n";
    RC_CLASSIFY(reached(world, plan) <= best * (1 + 1e-9), "the best");
    RC_CLASSIFY(reached(world, plan) <= best * 1.01, "within 1 %");
    RC_ASSERT(*plan.bound <= best * (1 + 1e-9));
    RC_ASSERT(reached(world, plan) >= best * (1 - 1e-6));
}

Method any_method() {
    Method method;
    method.select = *rc::gen::element(Selection::exact, Selection::hits, Selection::greedy, Selection::none);
    method.planner = method.select == Selection::greedy
                         ? Algorithm::optimal
                         : *rc::gen::element(Algorithm::optimal, Algorithm::theta, Algorithm::jps, Algorithm::astar);
    method.explain = *number(0, 3) == 0;
    return method;
}

RC_GTEST_PROP(UnderWay, EachMethodPlansWhatHolds, ()) {
    World world = any_world_under_way();
    Rules& rules = world.mission.rules;
    if (*number(0, 3) == 0) rules.timing = Timing::ignore;
    const Method method = any_method();
    if (method.select == Selection::exact && *number(0, 3) == 0) rules.minimise_demolition = 0.05;
    const Plan plan = Planner().plan(world.map, world.mission, method);
    RC_ASSERT(plan_faults(world.map, world.mission, plan) == "");
    for (const Plan& step : Planner().front(world.map, world.mission, method)) {
        Mission fewer = world.mission;
        RC_ASSERT(plan_faults(world.map, fewer, step) == "");
    }
}

// What is open from the start never was there.
RC_GTEST_PROP(UnderWay, AnOpeningAtZeroIsAMapWithoutTheObstacle, ()) {
    World world = any_world();
    RC_PRE(!world.map.obstacles().empty());
    const ObstacleId id = world.map.obstacles()[std::size_t(*number(0, int(world.map.obstacles().size()) - 1))].id;
    World without{world.map.with(std::vector{MapEdit::remove(id)}), world.mission};
    std::erase(without.mission.rules.protect, id);
    world.mission.rules.opened = {{id, 0}};
    const Method method = any_method();
    const Plan plan = Planner().plan(world.map, world.mission, method);
    const Plan same = Planner().plan(without.map, without.mission, method);
    RC_ASSERT(plan.status == same.status);
    RC_ASSERT(plan_faults(world.map, world.mission, plan) == "");
    if (plan.status != PlanStatus::solved) return;
    RC_ASSERT(reached(world, plan) == reached(without, same));
    RC_ASSERT(plan.bound == same.bound);
}

RC_GTEST_PROP(UnderWay, ALaterOpeningIsNeverBetter, ()) {
    World world = any_world_under_way();
    RC_PRE(!world.mission.rules.opened.empty());
    const Plan early = Planner().plan(world.map, world.mission);
    RC_PRE(early.gap == 0.0);
    world.mission.rules.opened[0].at += *rc::gen::element(0.5, 3.0, 20.0);
    RC_PRE(world.mission.rules.opened[0].at <= after_all);
    const Plan late = Planner().plan(world.map, world.mission);
    RC_ASSERT(reached(world, late) >= reached(world, early) * (1 - 1e-9));
}

// What opens after all have arrived stands for them all.
RC_GTEST_PROP(UnderWay, AnOpeningAfterAllIsNone, ()) {
    World world = any_world();
    set_out(world);
    RC_PRE(!world.map.obstacles().empty());
    const ObstacleId id = world.map.obstacles()[std::size_t(*number(0, int(world.map.obstacles().size()) - 1))].id;
    World standing = world;
    standing.mission.rules.protect.push_back(id);
    world.mission.rules.opened = {{id, after_all}};
    const Method method = any_method();
    const Plan plan = Planner().plan(world.map, world.mission, method);
    const Plan same = Planner().plan(standing.map, standing.mission, method);
    RC_ASSERT(plan_faults(world.map, world.mission, plan) == "");
    if (same.status != PlanStatus::solved) return;
    RC_LOG() << reached(world, plan) << " instead of " << reached(standing, same) << "\n";
    RC_ASSERT(reached(world, plan) <= reached(standing, same) * (1 + 1e-9));
    if (same.gap == 0.0) RC_ASSERT(reached(world, plan) >= reached(standing, same) * (1 - 1e-9));
}

TEST(UnderWay, AnAircraftIsReadyLaterAndElsewhere) {
    const Map map = map_from_ascii("..#..\n..#..");
    Mission mission = ground_and_air({0, 0}, {4, 0});
    mission.rules.removals = 1;
    Agent& air = mission.agents[1];
    air.start = {1, 1};
    air.from = Point(1.25, 0.75);
    air.ready_at = 3;
    air.approach = {{0.25, 0.75, 1}, {1.25, 0.75, 3}};
    const Plan plan = Planner().plan(map, mission);
    ASSERT_TRUE(is_valid(map, mission, plan));
    const std::vector<Waypoint>& path = plan.agents[1].path;
    ASSERT_GE(path.size(), 3U);
    EXPECT_EQ(path[0], (Waypoint{0.25, 0.75, 1}));
    EXPECT_EQ(path[1], (Waypoint{1.25, 0.75, 3}));
    ASSERT_EQ(plan.breaches.size(), 1U);
    EXPECT_DOUBLE_EQ(plan.breaches[0].cleared_at, 3 + std::hypot(0.25, 0.25));
    EXPECT_EQ(plan.agents[1].start, (Cell{1, 1}));
}

TEST(UnderWay, AVehicleWaitsForWhatOpensByItself) {
    const Map map = map_from_ascii("..#..\n..#..");
    Mission mission = ground_and_air({0, 0}, {4, 0});
    mission.rules.removals = 0;
    mission.rules.opened = {{{1}, 7}};
    const Plan plan = Planner().plan(map, mission);
    ASSERT_TRUE(is_valid(map, mission, plan));
    EXPECT_TRUE(plan.breaches.empty());
    EXPECT_NEAR(plan.agents[0].path.back().t, 10, 1e-9);
    ASSERT_EQ(plan.agents[0].waits.size(), 1U);
    EXPECT_EQ(plan.agents[0].waits[0].reason, WaitReason::opening);
    EXPECT_EQ(plan.agents[0].waits[0].obstacle, ObstacleId{1});
    EXPECT_EQ(plan.agents[0].waits[0].agent, "");
    mission.rules.timing = Timing::ignore;
    EXPECT_NEAR(Planner().plan(map, mission).agents[0].path.back().t, 4, 1e-9);
}

TEST(UnderWay, ALoneVehicleGoesAroundWhatOpensLate) {
    const Map map = map_from_ascii("...\n.#.\n...");
    for (const Algorithm planner : {Algorithm::optimal, Algorithm::theta, Algorithm::jps}) {
        Mission mission{{vehicle("v", {0, 1}, {2, 1})}};
        mission.rules.opened = {{{1}, 1}};
        Method method;
        method.planner = planner;
        EXPECT_NEAR(*Planner().plan(map, mission, method).after.makespan, 2.5, 1) << int(planner);
        mission.rules.opened = {{{1}, 100}};
        const Plan plan = Planner().plan(map, mission, method);
        ASSERT_TRUE(is_valid(map, mission, plan));
        EXPECT_NEAR(*plan.after.makespan, 4, 1e-9) << int(planner);
    }
}

std::string refusal(const Mission& mission) {
    return input_error([&] { validate(map_from_ascii("..#..\n....."), mission); });
}

TEST(UnderWay, MalformedMissionsAreRefused) {
    const Mission good = ground_and_air({0, 0}, {4, 0});
    EXPECT_EQ(refusal(good), "");
    Mission mission = good;
    mission.rules.opened = {{{1}, 2}};
    mission.rules.force = {{1}};
    EXPECT_NE(refusal(mission), "");
    mission.rules.force = {};
    mission.rules.protect = {{1}};
    EXPECT_EQ(refusal(mission), "");
    mission.rules.opened.push_back({{1}, 3});
    EXPECT_NE(refusal(mission), "");
    mission.rules.opened = {{{2}, 3}};
    EXPECT_NE(refusal(mission), "");
    mission.rules.opened = {{{1}, -1}};
    EXPECT_NE(refusal(mission), "");

    mission = good;
    mission.agents[0].from = Point(0.5, 0);
    EXPECT_NE(refusal(mission), "");
    mission = good;
    mission.agents[1].from = Point(1.5, 0);
    EXPECT_NE(refusal(mission), "");
    mission.agents[1].from = Point(0.5, 0);
    EXPECT_EQ(refusal(mission), "");

    Agent& driver = mission.agents[0];
    driver.ready_at = 4;
    driver.approach = {{0, 1, 1}, {0, 0, 4}};
    EXPECT_EQ(refusal(mission), "");
    driver.approach = {{0, 1, 1}, {0, 0, 3}};  // early
    EXPECT_NE(refusal(mission), "");
    driver.approach = {{0, 1, 1}, {0, 1, 4}};  // elsewhere
    EXPECT_NE(refusal(mission), "");
    driver.approach = {{0, 1, 5}, {0, 0, 4}};  // back in time
    EXPECT_NE(refusal(mission), "");
    driver.approach = {{4, 1, 3}, {0, 0, 4}};  // faster than it is
    EXPECT_NE(refusal(mission), "");
    driver.approach = {{infinity, 1, 3}, {0, 0, 4}};
    EXPECT_NE(refusal(mission), "");
}

// Starts and goals may lie where an obstacle has been.
TEST(UnderWay, AVehicleStartsInAnOpening) {
    const Map map = map_from_ascii("..#..\n.###.");
    Mission mission = ground_and_air({2, 1}, {4, 0});
    EXPECT_NE(input_error([&] { validate(map, mission); }), "");
    mission.rules.opened = {{{1}, 0}};
    EXPECT_TRUE(is_valid(map, mission, Planner().plan(map, mission)));
}

}  // namespace
}  // namespace waybreaker
