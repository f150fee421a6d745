// Aircraft that recharge at bases. Against every plan there is on small maps, and laws.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <random>

#include "ascii_map.hpp"
#include "checked_plan.hpp"
#include "coalition/agreement.hpp"
#include "coalition/every_plan.hpp"
#include "coalition/range_world.hpp"
#include "input_error.hpp"
#include "waybreaker/error.hpp"
#include "waybreaker/planner.hpp"

namespace waybreaker {
namespace {

// As those of ranges, with one or two bases for each aircraft, and batteries that may not be enough for the way home.
RangeWorld any_world_of_bases(std::mt19937& random, int most_vehicles) {
    RangeWorld world = any_range_world(random, most_vehicles);
    const auto below = [&](int count) { return int(random() % unsigned(count)); };
    world.mission.rules.removals = 1 + below(2);
    if (world.mission.agents.back().id == "air2" && below(3) > 0) world.mission.agents.pop_back();
    for (Agent& agent : world.mission.agents) {
        if (agent.kind == AgentKind::ground || below(5) == 0) continue;
        agent.recharge = std::array{0.25, 0.5, 2.0}[std::size_t(below(3))];
        agent.endurance = never;
        agent.range = (2 + 0.5 * below(8)) / (1 - agent.reserve);
        for (int i = 1 + below(2); i > 0; --i)
            agent.bases.push_back({below(world.map.width()), below(world.map.height())});
        if (below(3) == 0) agent.bases = {agent.start, agent.goal};
    }
    return world;
}

bool recharges(const Plan& plan) {
    return std::ranges::any_of(plan.agents, [](const Itinerary& agent) { return !agent.recharges.empty(); });
}

bool lands_more_often(const Plan& plan, int times) {
    return std::ranges::any_of(plan.agents,
                               [&](const Itinerary& agent) { return int(agent.recharges.size()) > times; });
}

void agree_with_every_landing(int most_vehicles, unsigned seed, int rounds, int least_as_good) {
    std::mt19937 random(seed);
    Agreement agreement;
    int recharging = 0;
    for (int round = 0; round < rounds; ++round) {
        SCOPED_TRACE(round);
        const RangeWorld world = any_world_of_bases(random, most_vehicles);
        const auto& [map, mission] = world;
        const double best = EveryPlan(map, mission).best();
        const Expected<Plan> plan = Planner().try_plan(map, mission);
        if (!plan) {
            EXPECT_TRUE(std::isinf(best)) << plan.error().detail;
        } else if (lands_more_often(*plan, EveryPlan::most_landings)) {
            EXPECT_EQ(plan_faults(map, mission, *plan), "");
            EXPECT_LE(plan->bound.value_or(0), best + 1e-6);
        } else if (agreement.holds(world, *plan, best)) {
            recharging += recharges(*plan) ? 1 : 0;
        }
    }
    EXPECT_GT(recharging, rounds / 20);
    agreement.expect_as_good(least_as_good);
}

TEST(Bases, OneVehicleAgreesWithEverySetOrderCellAndLanding) {
    agree_with_every_landing(1, 41, 1500, 98);
}

TEST(Bases, SeveralVehiclesAgreeWithEverySetOrderCellAndLanding) {
    agree_with_every_landing(3, 42, 1000, 97);
}

// It opens the wall only if it can recharge on the way.
TEST(Bases, BringWhatIsFarIntoRange) {
    const char* const picture = R"(
        ...............#.....
        S..............#....G
        ........B......#.....)";
    const Map map = map_from_ascii(picture);
    Mission mission = ground_and_air(mark_in_ascii(picture, 'S'), mark_in_ascii(picture, 'S'));
    mission.agents[0].goal = mark_in_ascii(picture, 'G');
    mission.rules.objective = Objective::ground_makespan;
    Agent& air = mission.agents[1];
    air.range = 16;
    EXPECT_EQ(Planner().plan(map, mission).status, PlanStatus::no_plan);
    air.recharge = 3;
    EXPECT_EQ(Planner().plan(map, mission).status, PlanStatus::no_plan);  // at home it is no nearer
    air.bases = {mark_in_ascii(picture, 'B')};
    const Plan plan = Planner().plan(map, mission);
    ASSERT_EQ(plan.status, PlanStatus::solved);
    EXPECT_TRUE(is_valid(map, mission, plan));
    ASSERT_EQ(plan.agents[1].recharges.size(), 2U);  // there and back
    const Recharge& recharge = plan.agents[1].recharges.front();
    EXPECT_EQ(recharge.at, air.bases.front());
    EXPECT_DOUBLE_EQ(recharge.until - recharge.from, 3);
    EXPECT_DOUBLE_EQ(recharge.flown, recharge.from);
    air.range = 8;
    EXPECT_EQ(Planner().plan(map, mission).status, PlanStatus::no_plan);
}

// Where the flight home is too long by itself.
TEST(Bases, LeadHomeInSteps) {
    const Map map = map_from_ascii("....................\n....................");
    Mission mission = ground_and_air({0, 0}, {19, 0});
    Agent& air = mission.agents[1];
    air.range = 7;
    air.recharge = 1.5;
    EXPECT_EQ(input_error([&] { (void)Planner().plan(map, mission); }),
              "the air agent can fly 7 cells; from its start to its goal it is 19, and no way over its bases has only "
              "shorter flights");
    air.bases = {{13, 0}, {6, 0}};
    const Plan plan = Planner().plan(map, mission);
    ASSERT_EQ(plan.status, PlanStatus::solved);
    EXPECT_TRUE(is_valid(map, mission, plan));
    EXPECT_DOUBLE_EQ(*plan.after.makespan, 22);
    EXPECT_EQ(plan.agents[1].recharges.size(), 2U);
    // The same for one that may breach nothing, and beside others.
    air.breaches = 0;
    mission.agents.push_back(aircraft("other", {0, 1}));
    const Plan idle = Planner().plan(map, mission);
    EXPECT_TRUE(is_valid(map, mission, idle));
    EXPECT_DOUBLE_EQ(*idle.after.makespan, 22);
    EXPECT_EQ(idle.agents[1].recharges.size(), 2U);
}

TEST(Bases, AreRefusedWhereTheyMeanNothing) {
    const Map map = map_from_ascii("....\n....");
    const auto refused = [&](const std::function<void(Agent&)>& change) {
        Mission mission = ground_and_air({0, 0}, {3, 0});
        change(mission.agents[1]);
        return input_error([&] { (void)Planner().plan(map, mission); });
    };
    EXPECT_EQ(refused([](Agent& air) { air.recharge = 1; }),
              "the air agent recharges, and has neither a range nor an endurance");
    EXPECT_EQ(refused([](Agent& air) {
                  air.range = 9;
                  air.bases = {{1, 1}};
              }),
              "the air agent has bases, and no time to recharge there");
    EXPECT_EQ(refused([](Agent& air) {
                  air.range = 9;
                  air.recharge = 0;
              }),
              "the air agent's time to recharge must be above 0, not 0");
    EXPECT_EQ(refused([](Agent& air) {
                  air.range = 9;
                  air.recharge = 1;
                  air.bases = {{4, 0}};
              }),
              "the base 4,0 of the air agent is off the map");
}

// To recharge where the battery is enough changes nothing.
TEST(Bases, ChangeNothingWhereTheBatteryIsEnough) {
    std::mt19937 random(43);
    for (int round = 0; round < 100; ++round) {
        auto [map, mission] = any_world_of_bases(random, 1 + round % 2);
        Mission enough = mission;
        for (Agent& agent : mission.agents) {
            agent.range = agent.endurance = never;
            agent.reserve = 0;
            agent.recharge.reset();
            agent.bases.clear();
        }
        for (Agent& agent : enough.agents) {
            if (agent.kind == AgentKind::ground) continue;
            agent.range = 1000;
            agent.endurance = never;
        }
        const Plan a = Planner().plan(map, mission);
        const Plan b = Planner().plan(map, enough);
        EXPECT_EQ(objective_of(mission, a), objective_of(enough, b)) << round;
        EXPECT_FALSE(recharges(b)) << round;
    }
}

// Nobody has to recharge.
TEST(Bases, NeverHurt) {
    std::mt19937 random(44);
    int compared = 0;
    for (int round = 0; round < 300; ++round) {
        auto [map, mission] = any_world_of_bases(random, 1 + round % 2);
        const Expected<Plan> plan = Planner().try_plan(map, mission);
        for (Agent& agent : mission.agents) {
            agent.recharge.reset();
            agent.bases.clear();
        }
        const Expected<Plan> once = Planner().try_plan(map, mission);
        if (!once || once->status != PlanStatus::solved) continue;
        ++compared;
        EXPECT_LE(objective_of(mission, *plan), objective_of(mission, *once) * (1 + 1e-9)) << round;
    }
    EXPECT_GT(compared, 100);
}

// Any mission, among other rules: what is planned is valid, and no worse than with nothing removed.
RC_GTEST_PROP(Bases, HoldForEveryPlan, ()) {
    std::mt19937 random(*rc::gen::arbitrary<unsigned>());
    auto [map, mission] = any_world_of_bases(random, 1 + int(random() % 3));
    mission.rules.collisions = true;
    mission.rules.rubble = random() % 4 == 0 ? 1 : 0;
    if (random() % 3 == 0) mission.agents.push_back(aircraft("free", mission.agents.front().start));
    Method method;
    method.select = *rc::gen::element(Selection::exact, Selection::exact, Selection::greedy, Selection::hits);
    method.explain = *rc::gen::arbitrary<bool>();
    const Expected<Plan> plan = Planner().try_plan(map, mission, method);
    RC_PRE(plan);
    RC_ASSERT(plan_faults(map, mission, *plan) == "");
    Mission none = mission;
    none.rules.removals = 0;
    const Plan without = Planner().plan(map, none, method);
    if (without.status != PlanStatus::solved || method.select != Selection::exact) return;
    RC_ASSERT(objective_of(mission, *plan) <= objective_of(none, without) * (1 + 1e-9));
}

}  // namespace
}  // namespace waybreaker
