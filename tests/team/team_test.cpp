// Teams: plans that judge and simulation pass, that say what they reach, and are the same each time.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cstddef>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "ascii_map.hpp"
#include "checked_plan.hpp"
#include "random_map.hpp"
#include "team/simulation.hpp"
#include "vehicle.hpp"
#include "waybreaker/error.hpp"
#include "waybreaker/planner.hpp"

namespace waybreaker {
namespace {

// Random vehicles with room at their starts and goals, and now and then an aircraft.
Mission any_team(const PlainMap& plain, const Map& map) {
    Mission mission;
    mission.rules.removals = 0;
    mission.rules.objective = *rc::gen::element(Objective::flowtime, Objective::makespan, Objective::ground_makespan);
    mission.rules.separation = *rc::gen::element(0.0, 0.0, 0.5);
    mission.rules.at_goal = *rc::gen::element(AtGoal::stay, AtGoal::stay, AtGoal::leave);
    const int vehicles = *number(2, 6);
    for (int tries = 0; tries < 40 && int(mission.agents.size()) < vehicles; ++tries) {
        Agent agent = vehicle(std::to_string(tries), any_free_cell(plain), any_free_cell(plain),
                              *rc::gen::element(0.2, 0.5, 0.5, 0.7, 1.1, 2.0));
        agent.speed = *rc::gen::element(1.0, 1.0, 0.5, 3.0);
        agent.ready_at = *rc::gen::element(0.0, 0.0, 2.5);
        mission.agents.push_back(agent);
        try {
            validate(map, mission);
        } catch (const InputError&) {
            mission.agents.pop_back();
        }
    }
    if (*number(0, 3) == 0) {
        mission.agents.push_back({"bird", AgentKind::air, any_cell(plain), any_cell(plain), 2});
    }
    RC_PRE(mission.is_team());
    return mission;
}

RC_GTEST_PROP(Team, PlansAreValid, ()) {
    const PlainMap plain = *random_map(16, 16);
    const Map map(plain.grid());
    const Mission mission = any_team(plain, map);
    RC_PRE(std::ranges::any_of(mission.agents, [](const Agent& a) { return a.kind == AgentKind::ground; }));
    const Plan plan = Planner().plan(map, mission);
    RC_TAG(plan.status == PlanStatus::solved ? "solved" : "not solved");
    RC_ASSERT(plan_faults(map, mission, plan) == "");
    if (plan.status != PlanStatus::solved) return;
    RC_ASSERT(simulate(map, mission, plan, 0.05) == "");
    RC_ASSERT(*plan.bound <= *value(plan.after, mission.rules.objective) + 1e-9);
    for (std::size_t i = 0; i < mission.agents.size(); ++i) {
        RC_ASSERT(*plan.after.routes[i].length >= distance(mission.agents[i].start, mission.agents[i].goal) - 1e-9);
    }
}

bool same(const Plan& a, const Plan& b) {
    const auto path = [](const Itinerary& x, const Itinerary& y) { return x.path == y.path; };
    return a.status == b.status && std::ranges::equal(a.agents, b.agents, path) && a.bound == b.bound;
}

// So many that one after the other does not do.
// Whoever is named first, and whatever their names: each agent drives the same path.
RC_GTEST_PROP(Team, IsPlannedTheSameInAnyOrder, ()) {
    const PlainMap plain = *random_map(12, 12);
    const Map map(plain.grid());
    const Mission mission = any_team(plain, map);
    Mission shuffled = mission;
    std::vector<std::size_t> order(mission.agents.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    for (std::size_t i = order.size(); i-- > 1;) std::swap(order[i], order[std::size_t(*number(0, int(i)))]);
    for (std::size_t i = 0; i < order.size(); ++i) {
        shuffled.agents[i] = mission.agents[order[i]];
        shuffled.agents[i].id = "agent " + std::to_string(i);
    }
    const Plan plan = Planner().plan(map, mission);
    const Plan other = Planner().plan(map, shuffled);
    RC_ASSERT(other.status == plan.status);
    RC_ASSERT(other.bound == plan.bound);
    RC_ASSERT(other.agents.size() == plan.agents.size());
    for (std::size_t i = 0; i < other.agents.size(); ++i) {
        RC_ASSERT(other.agents[i].path == plan.agents[order[i]].path);
        RC_ASSERT(other.agents[i].id == shuffled.agents[i].id);
    }
}

RC_GTEST_PROP(Team, CrowdsKeepClear, ()) {
    const PlainMap plain = *random_map(7, 7);
    const Map map(plain.grid());
    std::vector<Cell> free = plain.free_cells();
    RC_PRE(free.size() > 1);
    const auto take = [](std::vector<Cell>& cells) {
        const auto at = cells.begin() + *number(0, int(cells.size()) - 1);
        const Cell taken = *at;
        cells.erase(at);
        return taken;
    };
    Mission mission;
    mission.rules.removals = 0;
    mission.rules.objective = *rc::gen::element(Objective::flowtime, Objective::makespan);
    std::vector<Cell> starts = free;
    std::vector<Cell> goals = free;
    const double radius = *rc::gen::element(0.2, 0.354, 0.5);
    const double speed = *rc::gen::element(1.0, 3.0);
    const double ready_at = *rc::gen::element(0.0, 2.5);
    const int vehicles = *number(2, std::min(int(free.size()), 24));
    for (int i = 0; i < vehicles; ++i) {
        Agent agent = vehicle(std::to_string(i), take(starts), take(goals), radius);
        agent.speed = speed;
        agent.ready_at = ready_at;
        mission.agents.push_back(agent);
    }
    const Plan plan = Planner().plan(map, mission, {}, {.seconds = 0.2});
    RC_TAG(plan.status == PlanStatus::solved ? "solved" : "not solved");
    RC_ASSERT(plan_faults(map, mission, plan) == "");
    if (plan.status == PlanStatus::solved) RC_ASSERT(simulate(map, mission, plan, 0.05) == "");
}

// All change places with those opposite.
TEST(Team, OfACrowdFindsAPlan) {
    constexpr int side = 5;
    const Map map(Grid(side, side));
    Mission mission;
    mission.rules.removals = 0;
    mission.rules.objective = Objective::flowtime;
    for (int i = 0; i < 14; ++i) {
        const Cell start{i % side, i / side};
        mission.agents.push_back(vehicle(std::to_string(i), start, {side - 1 - start.x, side - 1 - start.y}, 0.354));
    }
    const Plan plan = Planner().plan(map, mission);
    EXPECT_EQ(plan.status, PlanStatus::solved);
    EXPECT_EQ(plan_faults(map, mission, plan), "");
}

TEST(Team, IsPlannedTheSameEachTime) {
    const Map map = map_from_ascii(R"(
        ..........
        ..##..##..
        ..........
        ..##..##..
        ..........)");
    Mission mission;
    mission.rules.objective = Objective::flowtime;
    for (int i = 0; i < 5; ++i) {
        mission.agents.push_back(vehicle("r" + std::to_string(i), {0, i}, {9, 4 - i}));
        mission.agents.push_back(vehicle("l" + std::to_string(i), {9, i}, {0, 4 - i}));
    }
    Planner used;
    const Plan first = used.plan(map, mission);
    ASSERT_EQ(first.status, PlanStatus::solved);
    EXPECT_FALSE(first.limit_reached);
    EXPECT_TRUE(is_valid(map, mission, first));
    EXPECT_TRUE(same(first, used.plan(map, mission)));
    EXPECT_TRUE(same(first, Planner().plan(map, mission)));
}

TEST(Team, OfOneIsItsShortestPath) {
    const Map map = map_from_ascii(R"(
        .....
        .###.
        .....)");
    Mission mission;
    mission.agents = {vehicle("only", {0, 0}, {4, 2})};
    const Plan plan = Planner().plan(map, mission);
    ASSERT_EQ(plan.status, PlanStatus::solved);
    EXPECT_TRUE(is_valid(map, mission, plan));
    EXPECT_DOUBLE_EQ(*plan.after.makespan, 6);
}

TEST(Team, LetsOneWaitAtACrossing) {
    const Map map = map_from_ascii(R"(
        ####.####
        ####.####
        .........
        ####.####
        ####.####)");
    Mission mission;
    mission.rules.objective = Objective::flowtime;
    mission.agents = {vehicle("across", {0, 2}, {8, 2}), vehicle("down", {4, 0}, {4, 4})};
    mission.agents[1].ready_at = 2;
    const Plan plan = Planner().plan(map, mission);
    ASSERT_EQ(plan.status, PlanStatus::solved);
    EXPECT_TRUE(is_valid(map, mission, plan));
    // Both would be in the middle at 4. Who lets the other one pass loses sqrt(2): at right angles, as fast, and a
    // cell wide, that is how far apart they have to be.
    EXPECT_NEAR(*plan.after.flowtime, 8 + 6 + std::sqrt(2), 1e-6);
}

// Though it has nowhere to go: others stay away until it vanishes.
TEST(Team, StandsWhereItIsUntilItIsReady) {
    const Map map{Grid(10, 10)};
    Mission mission;
    mission.rules.objective = Objective::flowtime;
    mission.agents = {vehicle("a", {4, 4}, {4, 4}), vehicle("b", {0, 4}, {9, 4})};
    mission.agents[0].ready_at = 3;
    mission.agents[1].speed = 4;
    for (const AtGoal at_goal : {AtGoal::leave, AtGoal::stay}) {
        mission.rules.at_goal = at_goal;
        const Plan plan = Planner().plan(map, mission);
        ASSERT_EQ(plan.status, PlanStatus::solved);
        EXPECT_TRUE(is_valid(map, mission, plan));
        EXPECT_EQ(simulate(map, mission, plan, 0.01), "");
        EXPECT_DOUBLE_EQ(plan.agents[0].path.back().t, 3);
        EXPECT_GT(plan.agents[1].path.back().t, 9.0 / 4);
        EXPECT_DOUBLE_EQ(*plan.before.flowtime, 3 + 9.0 / 4);
    }
}

// Room was left to vehicles without a path for ever longer, before all had one.
TEST(Team, WaitsForNobodyWhoHasLeft) {
    const Map map = map_from_ascii(R"(
        ....
        #...
        #...
        #...
        ##..
        ....
        #...
        #...)");
    Mission mission;
    mission.rules.separation = 0.5;
    mission.rules.objective = Objective::ground_makespan;
    mission.agents = {vehicle("0", {2, 7}, {3, 7}, 0.25), vehicle("1", {1, 6}, {3, 0}),
                      vehicle("2", {3, 1}, {1, 7}),       vehicle("3", {3, 6}, {0, 5}, 0.25),
                      vehicle("4", {1, 3}, {1, 3}),       vehicle("5", {2, 5}, {2, 6}, 0.25)};
    mission.agents[0].ready_at = 2.5;
    mission.agents[1].speed = mission.agents[3].speed = 3;
    mission.agents[5].speed = 0.5;
    const Plan plan = Planner().plan(map, mission);
    ASSERT_EQ(plan.status, PlanStatus::solved);
    EXPECT_TRUE(is_valid(map, mission, plan));
    EXPECT_LT(*plan.after.makespan, 20);
}

TEST(Team, HasNoPlanWhereOneHasNoWay) {
    const Map map = map_from_ascii("..#..\n..#..");
    Mission mission;
    mission.agents = {vehicle("a", {0, 0}, {1, 1}), vehicle("b", {1, 0}, {4, 0})};
    const Plan plan = Planner().plan(map, mission);
    EXPECT_EQ(plan.status, PlanStatus::no_plan);
    EXPECT_TRUE(is_valid(map, mission, plan));
}

TEST(Team, GivesUpWhereTwoCannotPass) {
    const Map map = map_from_ascii(".....");
    Mission mission;
    mission.agents = {vehicle("a", {0, 0}, {4, 0}), vehicle("b", {4, 0}, {0, 0})};
    const Plan plan = Planner().plan(map, mission);
    EXPECT_EQ(plan.status, PlanStatus::not_found);
    EXPECT_FALSE(plan.limit_reached);
    EXPECT_TRUE(is_valid(map, mission, plan));
    StopSource source;
    source.request_stop();
    EXPECT_EQ(Planner().plan(map, mission, {}, {.stop = source.get_token()}).status, PlanStatus::stopped);
}

// The message with which a mission is refused.
std::string refusal(const Map& map, const Mission& mission, const Method& method = {}) {
    try {
        Planner().plan(map, mission, method);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

TEST(Team, RefusesWhatCannotBePlanned) {
    const Map map = map_from_ascii(".....\n.....\n.....");
    const auto refused = [&](const Mission& mission, const std::string& why) {
        EXPECT_NE(refusal(map, mission).find(why), std::string::npos) << refusal(map, mission);
    };
    Mission mission;
    refused(mission, "no ground agent");
    mission.agents = {vehicle("a", {0, 0}, {4, 0}), vehicle("a", {0, 2}, {4, 2})};
    refused(mission, "two agents of the mission have the id 'a'");
    mission.agents[1].id = "b";
    mission.agents[1].start = {0, 0};
    refused(mission, "no room at their starts");
    mission.agents[1].start = {0, 2};
    mission.agents[1].goal = {4, 1};
    mission.rules.separation = 0.5;
    refused(mission, "no room at their goals");
    mission.rules.at_goal = AtGoal::leave;
    EXPECT_EQ(refusal(map, mission), "");
    mission.agents.push_back({"air", AgentKind::air, {0, 0}, {4, 0}});
    EXPECT_EQ(refusal(map, mission), "");
    mission.agents[2].ready_at = 1;
    EXPECT_EQ(refusal(map, mission), "");
    mission.agents[2].ready_at = 0;
    mission.agents[2].breaches = -1;
    refused(mission, "cannot breach less than no obstacle");
    mission.agents[2].breaches = 1;
    Method greedy;
    greedy.select = Selection::greedy;
    EXPECT_EQ(refusal(map, mission, greedy), "");
    Method nearest;
    nearest.flight = FlightRule::nearest;
    EXPECT_NE(refusal(map, mission, nearest).find("fly by optimal"), std::string::npos);
    Mission alone = mission;
    alone.agents.erase(alone.agents.begin());
    alone.agents.push_back({"second", AgentKind::air, {0, 0}, {4, 0}});
    EXPECT_EQ(refusal(map, alone, greedy), "");
    EXPECT_NE(refusal(map, alone, nearest).find("fly by optimal"), std::string::npos);
    mission.agents[0].breaches = 1;
    refused(mission, "the a agent drives");
    mission.agents[0].breaches = any_number;
    mission.agents.pop_back();
    mission.agents[0].ready_at = -1;
    refused(mission, "ready");
    mission.agents[0].ready_at = 0;
    mission.rules.separation = 33;
    refused(mission, "separation");
    Mission pair = ground_and_air({0, 0}, {4, 0});
    pair.agents[0].breaches = 2;
    refused(pair, "breaches is for air agents");
}

}  // namespace
}  // namespace waybreaker
