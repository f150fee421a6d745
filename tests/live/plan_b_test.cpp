// Plan B: what a mission comes to where a breach fails is what a mission costs that begins then and there.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "ascii_map.hpp"
#include "live/underway.hpp"
#include "waybreaker/revise.hpp"

namespace waybreaker {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

double reached(const Plan& plan, Objective objective) {
    return plan.status == PlanStatus::solved ? value(plan.after, objective).value_or(infinity) : infinity;
}

// The least objective over all sets of obstacles that a mission may remove, each planned alone.
double least_of_all_sets(Planner& planner, const Map& map, Mission mission, std::uint32_t first = 1) {
    Rules& rules = mission.rules;
    const int left = rules.removals;
    rules.removals = int(rules.force.size());
    double least = reached(planner.plan(map, mission), rules.objective);
    rules.removals = left;
    if (int(rules.force.size()) == left) return least;
    for (std::uint32_t id = first; id <= map.obstacles().size(); ++id) {
        const bool stays = std::ranges::find(rules.protect, ObstacleId{id}) != rules.protect.end();
        const bool opens =
            std::ranges::find(rules.opened, ObstacleId{id}, &TimedOpening::obstacle) != rules.opened.end();
        if (stays || opens || map.obstacle(ObstacleId{id}).gone()) continue;
        rules.force.push_back({id});
        least = std::min(least, least_of_all_sets(planner, map, mission, id + 1));
        rules.force.pop_back();
    }
    return least;
}

// A vehicle and an aircraft; what fails is not tried again.
Underway any_of_two() {
    const PlainMap plain = *random_map(9, 9);
    Underway drawn{Map(plain.grid()), {}};
    Agent rover = vehicle("rover", any_free_cell(plain), any_free_cell(plain));
    rover.speed = *rc::gen::element(0.5, 1.0, 2.0);
    drawn.mission.agents = {rover,
                            aircraft("heli", any_cell(plain), any_cell(plain), *rc::gen::element(0.5, 1.0, 4.0))};
    Rules& rules = drawn.mission.rules;
    rules.removals = *number(1, 2);
    rules.objective = *rc::gen::element(Objective::makespan, Objective::flowtime, Objective::ground_makespan);
    rules.breach_time.per_obstacle = *rc::gen::element(0.0, 2.5, 8.0);
    rules.rubble = *rc::gen::element(0.0, 0.0, 1.5);
    drawn.plan = Planner().plan(drawn.map, drawn.mission);
    RC_PRE(drawn.plan.status == PlanStatus::solved);
    RC_PRE(!drawn.plan.breaches.empty());
    return drawn;
}

// Where the agents are free to decide once the breach has failed, nothing behind them.
Mission begun_after(const Underway& old, std::size_t failed, const std::vector<Agent>& decide) {
    Mission fresh = old.mission;
    for (std::size_t i = 0; i < decide.size(); ++i) {
        fresh.agents[i].start = decide[i].start;
        fresh.agents[i].from = decide[i].from;
        fresh.agents[i].ready_at = decide[i].ready_at;
    }
    const double then = old.plan.breaches[failed].cleared_at;
    for (std::size_t i = 0; i < old.plan.breaches.size(); ++i) {
        const Breach& made = old.plan.breaches[i];
        // One that has begun by then is finished.
        if (i == failed || made.cleared_at - old.mission.rules.breach_time.per_obstacle > then + 1e-9) continue;
        fresh.rules.opened.push_back({made.obstacle, made.cleared_at});
        --fresh.rules.removals;
    }
    fresh.rules.protect.push_back(old.plan.breaches[failed].obstacle);
    return fresh;
}

RC_GTEST_PROP(PlanB, CostsWhatAMissionFromThereCosts, ()) {
    const Underway old = any_of_two();
    Planner planner;
    const Plan plan = with_plan_b(planner, old.map, old.mission, old.plan);
    RC_ASSERT(plan.breaches.size() == old.plan.breaches.size());
    for (std::size_t i = 0; i < plan.breaches.size(); ++i) {
        RC_ASSERT(plan.breaches[i].if_failed.has_value());
        const double stated = plan.breaches[i].if_failed->objective;
        State state{.sequence = 1, .now = plan.breaches[i].cleared_at};
        state.failed = {{plan.breaches[i].obstacle, state.now}};
        const Revision then = revise(planner, old.map, old.mission, old.plan, state);
        RC_CLASSIFY(then.status == RevisionStatus::broken, "cannot stop");
        if (then.status == RevisionStatus::broken) {
            RC_ASSERT(stated == infinity);
            continue;
        }
        const Mission left = begun_after(old, i, then.mission.agents);
        const Plan fresh = planner.plan(old.map, left);
        const double least = least_of_all_sets(planner, old.map, left);
        RC_CLASSIFY(least == infinity, "no plan");
        RC_CLASSIFY(least < infinity && stated <= least * (1 + 1e-9), "the best of all sets");
        RC_ASSERT((stated == infinity) == (least == infinity));
        if (least == infinity) continue;
        RC_ASSERT(std::abs(stated - reached(fresh, left.rules.objective)) <= 1e-9 * stated);
        // What is proven to be the best is.
        RC_ASSERT(least >= fresh.bound.value() * (1 - 1e-9));
    }
}

// No plan B is better than all plans.
RC_GTEST_PROP(PlanB, OfAnyMissionIsNoBetterThanWithoutTheObstacle, ()) {
    Underway old = any_underway(12);
    RC_PRE(!old.plan.breaches.empty());
    old.mission.rules.retries = 0;
    Planner planner;
    const Plan plan = with_plan_b(planner, old.map, old.mission, old.plan);
    for (const Breach& breach : plan.breaches) {
        if (!breach.if_failed) continue;  // a team's search may not find out
        Mission without = old.mission;
        without.rules.protect.push_back(breach.obstacle);
        const Plan fresh = planner.plan(old.map, without);
        if (fresh.status == PlanStatus::no_plan) RC_ASSERT(breach.if_failed->objective == infinity);
        if (fresh.bound) RC_ASSERT(breach.if_failed->objective >= *fresh.bound * (1 - 1e-9));
        RC_ASSERT(std::ranges::find(breach.if_failed->removed, breach.obstacle) == breach.if_failed->removed.end());
        RC_ASSERT(int(breach.if_failed->removed.size()) <= old.mission.rules.removals);
    }
}

TEST(PlanB, SaysWhatIsRemovedBeforeAndAfter) {
    // Two walls; the second has another opening, farther away.
    const Map map = Map::from_rows({
        "...A..B..",
        "...A..C..",
        "...A..C..",
        "...A..C..",
    });
    Mission mission = ground_and_air({0, 0}, {8, 0});
    mission.rules.breach_time.per_obstacle = 1;
    Planner planner;
    Plan plan = planner.plan(map, mission);
    ASSERT_EQ(plan.breaches.size(), 2U);
    plan = with_plan_b(planner, map, mission, std::move(plan));
    EXPECT_EQ(plan.breaches[0].if_failed, IfFailed{infinity});
    const IfFailed second = plan.breaches[1].if_failed.value_or(IfFailed{});
    EXPECT_GT(second.objective, *plan.after.makespan);
    EXPECT_EQ(second.removed, (std::vector{plan.breaches[0].obstacle, map.obstacle_at({6, 2})}));
}

TEST(PlanB, IsARetryWhereThatIsAllowed) {
    const Map map = Map::from_rows({"..A..", "..A..", "..A.."});
    Mission mission = ground_and_air({0, 1}, {4, 1});
    mission.rules.breach_time.per_obstacle = 2;
    mission.rules.retries = 1;
    Planner planner;
    Plan plan = planner.plan(map, mission);
    ASSERT_EQ(plan.breaches.size(), 1U);
    plan = with_plan_b(planner, map, mission, std::move(plan));
    const IfFailed again = plan.breaches[0].if_failed.value_or(IfFailed{});
    EXPECT_EQ(again.removed, std::vector{plan.breaches[0].obstacle});
    EXPECT_NEAR(again.objective, *plan.after.makespan + 2, 1e-9);
}

TEST(PlanB, IsNotStatedWithoutTime) {
    const Map map = Map::from_rows({"..A..", "..A..", "..A.."});
    const Mission mission = ground_and_air({0, 1}, {4, 1});
    Planner planner;
    const Plan plan = planner.plan(map, mission);
    const Plan none = with_plan_b(planner, map, mission, plan, {}, {.seconds = 1e-12});
    EXPECT_EQ(none.breaches[0].if_failed, std::nullopt);
}

}  // namespace
}  // namespace waybreaker
