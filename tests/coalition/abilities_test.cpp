// What each aircraft may breach, and how long it takes. Against every plan there is on small maps, and laws.
#include "abilities.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "ascii_map.hpp"
#include "checked_plan.hpp"
#include "coalition/agreement.hpp"
#include "coalition/every_plan.hpp"
#include "coalition/range_world.hpp"
#include "input_error.hpp"
#include "waybreaker/planner.hpp"

namespace waybreaker {
namespace {

// As those of ranges, most without an end of the battery.
RangeWorld any_world_of_abilities(std::mt19937& random, int most_vehicles) {
    RangeWorld world = any_range_world(random, most_vehicles);
    const auto below = [&](int count) { return int(random() % unsigned(count)); };
    for (Agent& agent : world.mission.agents) {
        if (below(4) == 0) continue;
        agent.range = agent.endurance = never;
        agent.reserve = 0;
    }
    give_abilities(world.map, world.mission, below);
    return world;
}

double reached_by(const RangeWorld& world) {
    return objective_of(world.mission, Planner().plan(world.map, world.mission));
}

void agree_with_what_is_able(int most_vehicles, unsigned seed, int rounds, int least_as_good) {
    std::mt19937 random(seed);
    Agreement agreement;
    int matters = 0;
    for (int round = 0; round < rounds; ++round) {
        SCOPED_TRACE(round);
        RangeWorld world = any_world_of_abilities(random, most_vehicles);
        auto& [map, mission] = world;
        const Plan plan = Planner().plan(map, mission);
        if (!agreement.holds(world, plan, EveryPlan(map, mission).best())) continue;
        for (Agent& agent : mission.agents) agent.can_breach.reset();
        matters += objective_of(mission, Planner().plan(map, mission)) < objective_of(mission, plan) - 1e-6 ? 1 : 0;
    }
    EXPECT_GT(matters, rounds / 20);
    agreement.expect_as_good(least_as_good);
}

TEST(Abilities, OneVehicleAgreesWithEverySetOrderAndCell) {
    agree_with_what_is_able(1, 51, 600, 98);
}

TEST(Abilities, SeveralVehiclesAgreeWithEverySetOrderAndCell) {
    agree_with_what_is_able(3, 52, 400, 98);
}

// Where every plan is found, who may breach less, or needs longer, is never sooner.
TEST(Abilities, ToBeAbleToDoLessNeverHelps) {
    std::mt19937 random(53);
    int worse = 0;
    for (int round = 0; round < 300; ++round) {
        RangeWorld world = any_world_of_abilities(random, 1);
        const double limited = reached_by(world);
        RangeWorld free = world;
        for (Agent& agent : free.mission.agents) agent.can_breach.reset();
        RangeWorld fast = world;
        for (Agent& agent : fast.mission.agents) {
            agent.breach_time = 0;
            agent.breach_time_per_cell = 0;
        }
        EXPECT_LE(EveryPlan(free.map, free.mission).best(), limited + 1e-6) << round;
        EXPECT_LE(EveryPlan(fast.map, fast.mission).best(), limited + 1e-6) << round;
        worse += reached_by(free) < limited - 1e-6 ? 1 : 0;
    }
    EXPECT_GT(worse, 10);
}

// The rules' own times, all obstacles by name, and a size that is none.
TEST(Abilities, ThatLimitNothingChangeNothing) {
    std::mt19937 random(54);
    for (int round = 0; round < 200; ++round) {
        const RangeWorld world = any_range_world(random, 1 + round % 3);
        RangeWorld same = world;
        const BreachTime& time = same.mission.rules.breach_time;
        for (Agent& agent : same.mission.agents) {
            agent.breach_time = time.per_obstacle;
            agent.breach_time_per_cell = time.per_cell;
            agent.can_breach.emplace().only.emplace();
            for (const Obstacle& obstacle : same.map.obstacles()) agent.can_breach->only->push_back(obstacle.id);
        }
        const Plan a = Planner().plan(world.map, world.mission);
        const Plan b = Planner().plan(same.map, same.mission);
        EXPECT_EQ(a.status, b.status) << round;
        EXPECT_EQ(objective_of(world.mission, a), objective_of(same.mission, b)) << round;
    }
}

// Any mission, among other rules, by any way to select.
RC_GTEST_PROP(Abilities, HoldForEveryPlan, ()) {
    std::mt19937 random(*rc::gen::arbitrary<unsigned>());
    auto [map, mission] = any_world_of_abilities(random, 1 + int(random() % 3));
    mission.rules.collisions = true;
    mission.rules.rubble = random() % 4 == 0 ? 1 : 0;
    if (random() % 4 == 0) mission.rules.force = {map.obstacles().front().id};
    Method method;
    method.select = *rc::gen::element(Selection::exact, Selection::exact, Selection::greedy, Selection::hits);
    method.explain = *rc::gen::arbitrary<bool>();
    const Expected<Plan> plan = Planner().try_plan(map, mission, method);
    RC_PRE(plan);
    RC_ASSERT(plan_faults(map, mission, *plan) == "");
    Mission none = mission;
    none.rules.removals = 0;
    none.rules.force.clear();
    const Plan without = Planner().plan(map, none, method);
    if (without.status != PlanStatus::solved || method.select != Selection::exact || !mission.rules.force.empty())
        return;
    RC_ASSERT(objective_of(mission, *plan) <= objective_of(none, without) * (1 + 1e-9));
}

// The nearest one may not, the other one is slow.
TEST(Abilities, TheOneThatCanOpensTheWall) {
    const char* const picture = R"(
        ......#......
        S.....#.....G
        ......#......)";
    const Map map = map_from_ascii(picture);
    Mission mission{{vehicle("rover", mark_in_ascii(picture, 'S'), mark_in_ascii(picture, 'G')),
                     aircraft("near", {5, 0}), aircraft("far", {0, 0})}};
    mission.rules.objective = Objective::ground_makespan;
    EXPECT_EQ(Planner().plan(map, mission).breaches.front().by, "near");
    mission.agents[1].can_breach = CanBreach{.most_cells = 2};
    mission.agents[2].breach_time = 7;
    mission.agents[2].breach_time_per_cell = 0.5;
    const Plan plan = Planner().plan(map, mission);
    EXPECT_EQ(plan_faults(map, mission, plan), "");
    ASSERT_EQ(plan.breaches.size(), 1U);
    EXPECT_EQ(plan.breaches.front().by, "far");
    EXPECT_DOUBLE_EQ(plan.breaches.front().cleared_at - *plan.breaches.front().begun_at, 8.5);
    mission.agents[2].can_breach = CanBreach{.only = std::vector<ObstacleId>()};
    EXPECT_EQ(Planner().plan(map, mission).status, PlanStatus::no_plan);
}

// What must be removed only the bulldozer can breach, which has no way.
TEST(Abilities, NobodyElseBreachesWhatMustBeRemoved) {
    const Map map = map_from_ascii(R"(
        ...#.......
        ...#...##..
        ...#...##..
        ...#.......
        ...#.......)");
    Mission mission{{vehicle("dozer", {5, 1}, {5, 3}), vehicle("car", {10, 2}, {1, 2}), aircraft("drone", {9, 0})}};
    mission.agents[0].own_breaches = 1;
    mission.agents[2].can_breach = CanBreach{.most_cells = 3};
    mission.rules.removals = 1;
    mission.rules.force = {{2}};
    EXPECT_NE(Planner().plan(map, mission).status, PlanStatus::solved);
}

TEST(Abilities, AreRefusedWhereTheyMeanNothing) {
    const Map map = map_from_ascii("..#.\n....");
    const auto refused = [&](auto change) {
        Mission mission = ground_and_air({0, 0}, {3, 0});
        change(mission, mission.agents[1]);
        return input_error([&] { (void)Planner().plan(map, mission); });
    };
    EXPECT_EQ(refused([](Mission&, Agent& air) { air.breach_time = -1; }),
              "the time of a breach of the air agent must be from 0 to 1e+09, not -1");
    EXPECT_EQ(refused([](Mission&, Agent& air) { air.breach_time_per_cell = never; }),
              "the time of a breach for each cell of the air agent must be from 0 to 1e+09, not inf");
    EXPECT_EQ(refused([](Mission&, Agent& air) { air.reach = 2; }), "the air agent flies: reach is for ground agents");
    EXPECT_EQ(refused([](Mission& mission, Agent&) { mission.agents[0].reach = 101; }),
              "the reach of the ground agent must be from 0 to 100, not 101");
    EXPECT_EQ(refused([](Mission&, Agent& air) { air.can_breach = CanBreach{.most_cells = 0}; }),
              "the air agent can breach obstacles of no cells: at least 1");
    EXPECT_EQ(refused([](Mission&, Agent& air) {
                  air.can_breach = CanBreach{.only = std::vector<ObstacleId>{{1}, {2}}};
              }),
              "the air agent can breach obstacle 2, which is not on the map");
    EXPECT_EQ(refused([](Mission& mission, Agent& air) {
                  air.can_breach = CanBreach{.only = std::vector<ObstacleId>()};
                  mission.rules.force = {{1}};
              }),
              "obstacle 1 must be removed, but no agent can breach it");
}

}  // namespace
}  // namespace waybreaker
