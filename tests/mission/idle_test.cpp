// Aircraft that may breach nothing change nothing but when all are home.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "ascii_map.hpp"
#include "checked_plan.hpp"
#include "random_map.hpp"
#include "vehicle.hpp"
#include "waybreaker/planner.hpp"

namespace waybreaker {
namespace {

// One vehicle and one aircraft, which have other starts and goals, speeds and breach times.
Mission any_pair(const PlainMap& plain) {
    Mission mission;
    mission.agents = {vehicle("rover", any_free_cell(plain), any_free_cell(plain)),
                      aircraft("heli", any_cell(plain), any_cell(plain), *rc::gen::element(0.5, 1.0, 4.0))};
    mission.agents[0].speed = *rc::gen::element(0.5, 1.0, 2.0);
    mission.agents[0].body.radius = *rc::gen::element(0.0, 0.5, 0.5);
    mission.agents[0].ready_at = *rc::gen::element(0.0, 0.0, 3.0, 12.0);
    Rules& rules = mission.rules;
    rules.removals = *number(0, 3);
    rules.objective = *rc::gen::element(Objective::makespan, Objective::flowtime, Objective::ground_makespan);
    rules.breach_time = {*rc::gen::element(0.0, 0.0, 2.5, 20.0), *rc::gen::element(0.0, 0.0, 0.5)};
    return mission;
}

RC_GTEST_PROP(IdleAircraft, ChangeNothing, ()) {
    const PlainMap plain = *random_map(16, 14);
    const Map map(plain.grid());
    const Mission pair = any_pair(plain);
    Mission team = pair;
    const int idle = *number(1, 3);
    for (int i = 0; i < idle; ++i) {
        Agent bird = aircraft("bird" + std::to_string(i), any_cell(plain), any_cell(plain), 3);
        bird.breaches = 0;
        if (*rc::gen::arbitrary<bool>()) bird.goal = bird.start;
        team.agents.insert(team.agents.begin() + *number(0, int(team.agents.size())), bird);
    }
    const Method method{.explain = *rc::gen::arbitrary<bool>()};
    const Plan alone = Planner().plan(map, pair, method);
    const Plan plan = Planner().plan(map, team, method);
    RC_ASSERT(plan.status == alone.status);
    RC_ASSERT(plan_faults(map, team, plan) == "");
    if (plan.status != PlanStatus::solved) return;
    RC_ASSERT(plan.breaches.size() == alone.breaches.size());
    for (const Itinerary& agent : alone.agents) {
        const auto same = std::ranges::find(plan.agents, agent.id, &Itinerary::id);
        RC_ASSERT(same->path == agent.path);
    }
    if (pair.rules.objective == Objective::ground_makespan) RC_ASSERT(plan.bound == alone.bound);
    RC_ASSERT(*plan.gap <= *alone.gap + 1e-9);
}

RC_GTEST_PROP(IdleAircraft, TheCurveIsTheSame, ()) {
    const PlainMap plain = *random_map(12, 12);
    const Map map(plain.grid());
    Mission pair = any_pair(plain);
    pair.rules.objective = Objective::ground_makespan;
    Mission team = pair;
    team.agents.push_back(aircraft("bird", any_cell(plain), any_cell(plain)));
    team.agents.back().breaches = 0;
    const std::vector<Plan> alone = Planner().front(map, pair);
    const std::vector<Plan> plans = Planner().front(map, team);
    RC_ASSERT(plans.size() == alone.size());
    for (std::size_t i = 0; i < plans.size(); ++i) {
        RC_ASSERT(plans[i].after.ground_makespan == alone[i].after.ground_makespan);
        RC_ASSERT(plans[i].bound == alone[i].bound);
    }
}

// Nor whether there is one at all.
RC_GTEST_PROP(IdleAircraft, BesideAVehicleAloneChangesNothing, ()) {
    const PlainMap plain = *random_map(16, 14);
    const Map map(plain.grid());
    Mission pair = any_pair(plain);
    pair.agents[0].body.radius = *rc::gen::element(0.0, 0.3, 0.5, 0.8);
    pair.agents[1].breaches = 0;
    Mission vehicle = pair;
    vehicle.agents.pop_back();
    vehicle.rules.objective = pair.rules.objective = Objective::ground_makespan;
    std::vector<ObstacleId> open = some_obstacles(map, 2);
    std::ranges::sort(open);
    open.erase(std::unique(open.begin(), open.end()), open.end());
    for (const ObstacleId id : open) {
        const double opens = *number(0, 9);
        for (Mission* mission : {&vehicle, &pair}) mission->rules.opened.push_back({id, opens});
    }
    std::optional<Plan> alone;
    try {
        alone = Planner().plan(map, vehicle);
    } catch (const InputError&) {
        RC_DISCARD("no room at the start or the goal");
    }
    const Plan beside = Planner().plan(map, pair);
    RC_ASSERT(plan_faults(map, vehicle, *alone) == "");
    RC_ASSERT(beside.status == alone->status);
    if (alone->status != PlanStatus::solved) return;
    RC_ASSERT(beside.agents[0].path == alone->agents[0].path);
    RC_ASSERT(beside.bound == alone->bound);
    RC_ASSERT(beside.before.ground().length == alone->before.ground().length);
}

// One that may breach fewer than the rules allow is as good as rules that allow no more.
RC_GTEST_PROP(Capacity, OfTheOnlyAircraftIsANumberOfRemovals, ()) {
    const PlainMap plain = *random_map(16, 14);
    const Map map(plain.grid());
    Mission few = any_pair(plain);
    few.rules.removals = *number(0, 2);
    Mission able = few;
    able.rules.removals = few.rules.removals + 1;
    able.agents[1].breaches = few.rules.removals;
    const Plan plan = Planner().plan(map, able, {.explain = true});
    const Plan other = Planner().plan(map, few);
    RC_ASSERT(plan_faults(map, able, plan) == "");
    RC_ASSERT(plan.next.empty());
    RC_ASSERT(plan.agents.size() == other.agents.size());
    for (std::size_t i = 0; i < plan.agents.size(); ++i) RC_ASSERT(plan.agents[i].path == other.agents[i].path);
}

TEST(IdleAircraft, AreHomeWhenTheyAre) {
    const Map map = map_from_ascii("..a..\n..a..\n..a..");
    Mission mission;
    mission.agents = {aircraft("far", {0, 0}, {4, 2}, 0.1), vehicle("rover", {0, 1}, {4, 1}),
                      aircraft("heli", {0, 1}, {4, 1})};
    mission.agents[0].breaches = 0;
    mission.rules.removals = 1;
    const Plan plan = Planner().plan(map, mission);
    ASSERT_TRUE(is_valid(map, mission, plan));
    ASSERT_EQ(plan.breaches.size(), 1U);
    EXPECT_EQ(plan.breaches[0].by, "heli");
    EXPECT_NEAR(*plan.after.makespan, 10 * distance(Cell{0, 0}, Cell{4, 2}), 1e-9);
    EXPECT_EQ(plan.gap, 0);
}

}  // namespace
}  // namespace waybreaker
