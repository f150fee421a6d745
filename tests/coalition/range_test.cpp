// Aircraft that come home before their battery is empty. Against every plan there is on small maps, and laws.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <string>

#include "ascii_map.hpp"
#include "checked_plan.hpp"
#include "coalition/agreement.hpp"
#include "coalition/every_plan.hpp"
#include "coalition/range_world.hpp"
#include "input_error.hpp"
#include "plain_map.hpp"
#include "waybreaker/error.hpp"
#include "waybreaker/planner.hpp"

namespace waybreaker {
namespace {

Mission without_ranges(Mission mission) {
    for (Agent& agent : mission.agents) {
        agent.range = agent.endurance = never;
        agent.reserve = 0;
    }
    return mission;
}

std::string text_of(const Plan& plan) {
    std::string text = std::string(to_string(plan.status));
    const auto add = [&](double number) { text += " " + std::to_string(number); };
    for (const Itinerary& agent : plan.agents) {
        text += "\n" + agent.id;
        for (const Waypoint& p : agent.path) {
            for (const double number : {p.x, p.y, p.t}) add(number);
        }
    }
    for (const Breach& breach : plan.breaches) {
        for (const double number : {double(breach.obstacle.value), double(breach.at.x), double(breach.at.y)})
            add(number);
        text += " " + breach.by;
    }
    for (const auto& number : {plan.bound, plan.gap, plan.before.makespan, plan.after.flowtime})
        add(number.value_or(-1));
    return text;
}

void agree_with_every_plan(int most_vehicles, unsigned seed, int rounds, int least_as_good) {
    std::mt19937 random(seed);
    Agreement agreement;
    int limiting = 0;
    for (int round = 0; round < rounds; ++round) {
        SCOPED_TRACE(round);
        const RangeWorld world = any_range_world(random, most_vehicles);
        const auto& [map, mission] = world;
        const double best = EveryPlan(map, mission).best();
        if (!agreement.holds(world, Planner().plan(map, mission), best)) continue;
        limiting += best > EveryPlan(map, without_ranges(mission)).best() + 1e-6 ? 1 : 0;
    }
    EXPECT_GT(limiting, rounds / 20);
    agreement.expect_as_good(least_as_good);
}

TEST(Range, OneVehicleAgreesWithEverySetOrderAndCell) {
    agree_with_every_plan(1, 31, 400, 98);
}

TEST(Range, SeveralVehiclesAgreeWithEverySetOrderAndCell) {
    agree_with_every_plan(3, 32, 300, 97);
}

// Of any such mission; RC_PARAMS says of how many.
RC_GTEST_PROP(Range, IsHeldAgainstEveryPlan, ()) {
    std::mt19937 random(*rc::gen::arbitrary<unsigned>());
    const auto [map, mission] = any_range_world(random, 1 + int(random() % 3));
    const double best = EveryPlan(map, mission).best();
    const Plan plan = Planner().plan(map, mission);
    RC_ASSERT(plan_faults(map, mission, plan) == "");
    RC_ASSERT((plan.status == PlanStatus::solved) == std::isfinite(best));
    if (std::isinf(best)) return;
    RC_ASSERT(plan.bound.value_or(0) <= best + 1e-6);
    RC_ASSERT(objective_of(mission, plan) >= best - 1e-6);
}

// Each of two walls is in range of an aircraft, and both of neither.
TEST(Range, SharesASetInTheOnlyWayThereIs) {
    const char* const picture = R"(
        ..a......b..
        ..a......b..
        S.a......b.G
        ..a......b..
        ..a......b..)";
    const Map map = map_from_ascii(picture);
    const Cell middle{5, 2};
    Mission mission;
    mission.agents = {vehicle("rover", mark_in_ascii(picture, 'S'), mark_in_ascii(picture, 'G')),
                      aircraft("air1", middle), aircraft("air2", middle)};
    mission.rules.force = {map.obstacle_at({2, 0}), map.obstacle_at({9, 0})};
    mission.agents[1].range = 4;  // to the left and back
    mission.agents[2].range = 6;  // to the right and back
    const Plan plan = Planner().plan(map, mission);
    ASSERT_EQ(plan.status, PlanStatus::solved);
    EXPECT_TRUE(is_valid(map, mission, plan));
    mission.agents[2].range = 5;
    EXPECT_EQ(input_error([&] { (void)Planner().plan(map, mission); }),
              "obstacle 2 must be removed, but the air2 agent can fly 5 cells; obstacle 2 and back is 6");
    // One aircraft gets to either of them, and not to both.
    mission.agents.pop_back();
    mission.agents[1].range = 9;
    EXPECT_EQ(Planner().plan(map, mission).status, PlanStatus::no_plan);
    mission.agents[1].range = 10;
    EXPECT_EQ(Planner().plan(map, mission).status, PlanStatus::solved);
}

TEST(Range, ExplainsWhatItCouldNotReach) {
    const char* const picture = R"(
        ...............#.....
        S..............#....G
        .....................)";
    const Map map = map_from_ascii(picture);
    Mission mission = ground_and_air(mark_in_ascii(picture, 'S'), mark_in_ascii(picture, 'S'));
    mission.agents[0].goal = mark_in_ascii(picture, 'G');
    mission.rules.objective = Objective::ground_makespan;
    Method method;
    method.explain = true;
    const Plan far = Planner().plan(map, mission, method);
    ASSERT_EQ(far.breaches.size(), 1U);
    EXPECT_TRUE(far.out_of_range.empty());
    mission.agents[1].range = 20;
    const Plan near = Planner().plan(map, mission, method);
    ASSERT_EQ(near.status, PlanStatus::solved);
    EXPECT_TRUE(near.breaches.empty());
    ASSERT_EQ(near.out_of_range.size(), 1U);
    EXPECT_EQ(near.out_of_range.front().agent, "air");
    EXPECT_DOUBLE_EQ(near.out_of_range.front().longest, 20);
    EXPECT_DOUBLE_EQ(near.out_of_range.front().flight, 28);
    EXPECT_TRUE(is_valid(map, mission, near));
    mission.agents[1].range = 35;
    mission.agents[1].reserve = 0.2;
    EXPECT_EQ(Planner().plan(map, mission, method).breaches.size(), 1U);
}

// Who has more than the unlimited plan takes flies it.
TEST(Range, ChangesNothingWhereItIsEnough) {
    std::mt19937 random(33);
    for (int round = 0; round < 200; ++round) {
        const RangeWorld world = any_range_world(random, 1 + round % 3);
        Mission mission = without_ranges(world.mission);
        const Plan plan = Planner().plan(world.map, mission);
        if (plan.status != PlanStatus::solved) continue;
        for (std::size_t i = 0; i < mission.agents.size(); ++i) {
            Agent& agent = mission.agents[i];
            if (agent.kind == AgentKind::ground) continue;
            const double flown = plan.agents[i].path.back().t - agent.ready_at;
            agent.range = std::max(flown * agent.speed, 1e-3);
            agent.endurance = std::max(flown, 1e-3);
        }
        EXPECT_EQ(text_of(Planner().plan(world.map, mission)), text_of(plan)) << round;
    }
}

// Where the loop ends by proof.
TEST(Range, IsNeverWorseForMore) {
    std::mt19937 random(34);
    int proven = 0;
    for (int round = 0; round < 200; ++round) {
        auto [map, mission] = any_range_world(random, 1 + round % 3);
        const Plan less = Planner().plan(map, mission);
        for (Agent& agent : mission.agents) {
            agent.range *= 1 + double(random() % 100) / 50;
            agent.endurance *= 1 + double(random() % 100) / 50;
        }
        const Plan more = Planner().plan(map, mission);
        if (less.status != PlanStatus::solved) continue;
        ASSERT_EQ(more.status, PlanStatus::solved) << round;
        if (more.gap.value_or(1) > 1e-9) continue;
        ++proven;
        EXPECT_LE(objective_of(mission, more), objective_of(mission, less) * (1 + 1e-9)) << round;
    }
    EXPECT_GT(proven, 50);
}

// By every way to choose, as a front and as alternatives, among all other rules; whatever is refused says why.
RC_GTEST_PROP(Range, HoldsForEveryPlan, ()) {
    std::mt19937 random(*rc::gen::arbitrary<unsigned>());
    auto [map, mission] = any_range_world(random, 1 + int(random() % 2));
    Rules& rules = mission.rules;
    const auto any_obstacle = [&] { return map.obstacles()[random() % map.obstacles().size()].id; };
    Method method;
    method.select = *rc::gen::element(Selection::exact, Selection::greedy, Selection::hits, Selection::none);
    method.explain = *rc::gen::arbitrary<bool>();
    method.bound = *rc::gen::arbitrary<bool>();
    if (*rc::gen::element(true, false, false)) rules.force = {any_obstacle()};
    if (*rc::gen::element(true, false, false)) rules.opened = {{any_obstacle(), 3}};
    if (*rc::gen::element(true, false, false, false)) rules.timing = Timing::ignore;
    if (*rc::gen::element(true, false, false, false)) rules.minimise_demolition = 0.1;
    if (*rc::gen::element(true, false, false)) {
        const double x = 1 + double(random() % 4);
        rules.zones = {{.polygon = {{{x, -0.4}, {x + 1.3, 1.6}, {x - 0.8, 1.9}}}}};
    }
    if (mission.agents.size() == 2) method.flight = *rc::gen::element(FlightRule::optimal, FlightRule::nearest);
    try {
        const Plan plan = Planner().plan(map, mission, method);
        RC_ASSERT(plan_faults(map, mission, plan) == "");
        for (const Plan& step : Planner().front(map, mission, method)) RC_ASSERT(plan_faults(map, mission, step) == "");
        for (const Plan& other : Planner().alternatives(map, mission, 0.5, method))
            RC_ASSERT(plan_faults(map, mission, other) == "");
    } catch (const InputError& error) {
        RC_DISCARD(std::string(error.what()));
    }
}

TEST(Range, NamesWhatCannotBe) {
    const Map map = map_from_ascii(R"(
        ......
        ....#.
        ......)");
    Mission mission = ground_and_air({0, 0}, {5, 0});
    const auto error = [&] { return input_error([&] { validate(map, mission); }); };
    mission.agents[1].range = 4;
    EXPECT_EQ(error(), "the air agent can fly 4 cells; from its start to its goal it is 5");
    mission.agents[1].range = 6;
    mission.agents[1].reserve = 0.25;
    EXPECT_EQ(error(), "the air agent can fly 4.5 cells, with 25 % in reserve; from its start to its goal it is 5");
    mission.agents[1].reserve = 0;
    mission.agents[1].range = never;
    mission.agents[1].speed = 2;
    mission.agents[1].endurance = 2;
    EXPECT_EQ(error(), "the air agent can fly for 2 units of time; from its start to its goal it takes 2.5");
    mission.agents[1].endurance = 3;
    mission.rules.force = {map.obstacle_at({4, 1})};
    mission.rules.breach_time.per_obstacle = 1;
    EXPECT_EQ(
        error(),
        "obstacle 1 must be removed, but the air agent can fly for 3 units of time; obstacle 1 and back takes 3.5");
    mission.rules.force.clear();
    EXPECT_EQ(error(), "");
    mission.agents[1].range = 0;
    EXPECT_EQ(error(), "the air agent's range must be above 0, not 0");
    mission.agents[1].range = NAN;
    EXPECT_EQ(error(), "the air agent's range must be above 0, not nan");
    mission.agents[1].range = never;
    mission.agents[1].reserve = 1;
    EXPECT_EQ(error(), "the air agent keeps all of its range in reserve");
    mission.agents[1].endurance = never;
    mission.agents[1].reserve = 0.5;
    EXPECT_EQ(error(), "the air agent has a reserve, and neither a range nor an endurance");
    mission.agents[1].reserve = 0;
    mission.agents[0].range = 9;
    EXPECT_EQ(error(), "the ground agent drives: range, endurance, reserve, recharge and bases are for air agents");
    mission.agents[0].range = never;
    mission.agents[1].flown = 1;
    EXPECT_EQ(error(), "the air agent has flown, and has neither a range nor an endurance");
    mission.agents[1].range = 9;
    EXPECT_EQ(error(), "");
    mission.agents[1].flown = 2.5;
    EXPECT_EQ(error(), "the air agent can still fly 4 cells; from its start to its goal it is 5");
    mission.agents[1].flown = -1;
    EXPECT_EQ(error(), "the time that the air agent has flown must be from 0 to 1e+09, not -1");
}

}  // namespace
}  // namespace waybreaker
