// Plans of small missions against all plans there are.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cstdint>
#include <limits>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "all_plans.hpp"
#include "checked_plan.hpp"
#include "mission/any_world.hpp"
#include "waybreaker/planner.hpp"

namespace waybreaker {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Both agents drive and fly from start to goal; whoever is on the ground is to arrive soon, with two removals.
World world_of(const std::vector<std::string>& rows, Cell start, Cell goal) {
    std::vector<std::uint32_t> labels;
    for (const std::string& row : rows) {
        for (const char c : row) labels.push_back(c == '.' ? 0 : std::uint32_t(c - 'a' + 1));
    }
    World world{Map::from_labels(int(rows.front().size()), int(rows.size()), labels), ground_and_air(start, goal)};
    world.mission.rules.removals = 2;
    world.mission.rules.objective = Objective::ground_makespan;
    return world;
}

std::string picture(const World& world) {
    std::ostringstream text;
    for (Cell c; c.y < world.map.height(); ++c.y) {
        for (c.x = 0; c.x < world.map.width(); ++c.x) text << ".abcdef"[world.map.obstacle_at(c).value];
        text << '\n';
    }
    for (const Obstacle& o : world.map.obstacles()) {
        if (!o.destructible) text << ".abcdef"[o.id.value] << " stays\n";
    }
    for (const Agent& agent : world.mission.agents) {
        text << agent.id << ' ' << agent.start.x << ',' << agent.start.y << " to " << agent.goal.x << ','
             << agent.goal.y << " at " << agent.speed << '\n';
    }
    const Rules& rules = world.mission.rules;
    text << "n = " << rules.removals << ", objective " << int(rules.objective) << ", breach time "
         << rules.breach_time.per_obstacle << " and " << rules.breach_time.per_cell << " for each cell\n";
    return text.str();
}

void expect_between_bound_and_plan(const World& world) {
    const Plan plan = Planner().plan(world.map, world.mission);
    RC_LOG() << picture(world);
    RC_ASSERT(plan_faults(world.map, world.mission, plan) == "");
    const double best = AllPlans(world.map, world.mission).best();
    if (plan.status != PlanStatus::solved) {
        RC_ASSERT(best == infinity);
        RC_CLASSIFY(true, "no plan");
        return;
    }
    const double reached = *value(plan.after, world.mission.rules.objective);
    RC_LOG() << "reached " << reached << ", best " << best << ", bound " << *plan.bound << "\n";
    RC_CLASSIFY(reached <= best * (1 + 1e-9), "the best");
    RC_CLASSIFY(reached <= best * 1.01, "within 1 %");
    RC_ASSERT(*plan.bound <= best * (1 + 1e-9));
    RC_ASSERT(reached >= best * (1 - 1e-6));
}

RC_GTEST_PROP(Oracle, NoPlanIsBelowTheBoundAndNoneBeatsAllPlans, ()) {
    expect_between_bound_and_plan(any_world());
}

RC_GTEST_PROP(Oracle, TheSameForSeveralAircraft, ()) {
    World world = any_world();
    std::vector<Agent>& agents = world.mission.agents;
    const int more = *number(1, 2);
    for (int i = 0; i < more; ++i) {
        Agent agent = agents[1];
        agent.id += std::to_string(i);
        if (*rc::gen::arbitrary<bool>()) {
            agent.start = {*number(0, world.map.width() - 1), *number(0, world.map.height() - 1)};
        }
        agent.speed = *rc::gen::element(0.5, 1.0, 3.0);
        agents.push_back(agent);
    }
    if (*number(0, 1) == 0) agents[1].breaches = *number(0, 1);
    expect_between_bound_and_plan(world);
}

RC_GTEST_PROP(Oracle, TheSameWithWhatMustBeRemoved, ()) {
    World world = any_world();
    Rules& rules = world.mission.rules;
    rules.protect.clear();
    std::vector<ObstacleId> removable;
    for (const Obstacle& obstacle : world.map.obstacles()) {
        if (obstacle.destructible) removable.push_back(obstacle.id);
    }
    RC_PRE(!removable.empty());
    rules.force = {*rc::gen::elementOf(removable)};
    expect_between_bound_and_plan(world);
}

// Each world was once planned worse, for the reason given.
TEST(Oracle, NoneBeatsThePlan) {
    World gate_where_an_obstacle_stood = world_of({"a.bcc.", "a.bb..", ".bc..b", ".a..b."}, {5, 0}, {1, 1});
    gate_where_an_obstacle_stood.mission.agents[1].speed = 0.5;

    World wait_on_the_way_to_a_gate = world_of({"..ab.", "aca..", "b...a", "..c.."}, {0, 0}, {4, 0});
    wait_on_the_way_to_a_gate.mission.agents[0].speed = 0.5;
    wait_on_the_way_to_a_gate.mission.agents[1].speed = 0.5;
    wait_on_the_way_to_a_gate.mission.rules.breach_time.per_obstacle = 4.5;

    World entered_in_time_elsewhere = world_of({"a.....", ".ab.bc", "..a.aa", "c...a.", ".c..ca"}, {4, 0}, {1, 2});
    entered_in_time_elsewhere.mission.agents[0].speed = 0.5;
    entered_in_time_elsewhere.mission.agents[1].start = {1, 3};
    entered_in_time_elsewhere.mission.rules.breach_time.per_obstacle = 1;

    World disc_later_than_its_square = world_of({".abb.", "a....", "abbb.", "a.cab", "acc.a"}, {0, 0}, {1, 3});
    disc_later_than_its_square.mission.agents[1].speed = 3;
    disc_later_than_its_square.mission.rules.breach_time.per_obstacle = 1;

    for (const World& world : {gate_where_an_obstacle_stood, wait_on_the_way_to_a_gate, entered_in_time_elsewhere,
                               disc_later_than_its_square}) {
        const Plan plan = Planner().plan(world.map, world.mission);
        const double best = AllPlans(world.map, world.mission).best();
        EXPECT_NEAR(*value(plan.after, world.mission.rules.objective), best, 1e-9) << picture(world);
    }
}

// The same worlds each time, so that what is measured is what is allowed.
TEST(Oracle, HardlyAnyPlanIsBeaten) {
    constexpr int most_beaten = 4;  // of 2000
    const rc::Gen<World> worlds = rc::gen::exec([] { return any_world(); });
    int plans = 0;
    int beaten = 0;
    for (std::uint64_t seed = 0; plans < 2000; ++seed) {
        std::optional<World> world;
        try {
            world = worlds(rc::Random(seed), rc::kNominalSize).value();
        } catch (const rc::detail::CaseResult&) {
            continue;  // no free cell
        }
        const Plan plan = Planner().plan(world->map, world->mission);
        if (plan.status != PlanStatus::solved) continue;
        ++plans;
        const double reached = *value(plan.after, world->mission.rules.objective);
        if (AllPlans(world->map, world->mission).best() < reached * (1 - 1e-9)) ++beaten;
    }
    EXPECT_LE(beaten, most_beaten);
}

RC_GTEST_PROP(Oracle, APlanLosesNoMoreThanTheGapAskedFor, ()) {
    const World world = any_world();
    const double gap = *rc::gen::element(0.01, 0.1, 0.5);
    const Plan best = Planner().plan(world.map, world.mission);
    const Plan plan = Planner().plan(world.map, world.mission, {}, {.gap = gap});
    RC_LOG() << picture(world) << "gap " << gap << "\n";
    RC_ASSERT(plan_faults(world.map, world.mission, plan) == "");
    RC_ASSERT(plan.status == best.status);
    if (plan.status != PlanStatus::solved) return;
    const double least = *value(best.after, world.mission.rules.objective);
    const double reached = *value(plan.after, world.mission.rules.objective);
    RC_LOG() << "reached " << reached << ", " << least << " without a gap, bound " << *plan.bound << "\n";
    RC_ASSERT(*plan.bound <= AllPlans(world.map, world.mission).best() * (1 + 1e-9));
    // Choices are compared by paths of the square, which are at most that much longer than the disc's.
    constexpr double most_of_square = 1.0824;
    RC_ASSERT(reached <= least * (1 + gap) * most_of_square);
    RC_CLASSIFY(reached > least * (1 + 1e-9), "a worse plan");
    RC_CLASSIFY(*plan.gap <= gap, "proven");
}

// One removal saves 0.4 %.
TEST(Oracle, WhatGainsLessThanTheGapStays) {
    std::vector<std::string> rows(3, std::string(50, '.'));
    rows[1][25] = 'a';
    World world = world_of(rows, {0, 1}, {49, 1});
    const auto plan = [&](double gap) { return Planner().plan(world.map, world.mission, {}, {.gap = gap}); };
    EXPECT_EQ(plan(0).breaches.size(), 1U);
    EXPECT_EQ(plan(1e-4).breaches.size(), 1U);
    const Plan near = plan(0.01);
    EXPECT_TRUE(near.breaches.empty());
    EXPECT_FALSE(near.limit_reached);
    EXPECT_NEAR(*near.gap, 0.01, 1e-9);
}

// How much more the plan costs than one that must remove the same.
double loss_to_forced(World world) {
    const Plan plan = Planner().plan(world.map, world.mission);
    if (plan.status != PlanStatus::solved || plan.breaches.empty()) return 0;
    for (const Breach& breach : plan.breaches) world.mission.rules.force.push_back(breach.obstacle);
    world.mission.rules.removals = int(plan.breaches.size());
    const Plan forced = Planner().plan(world.map, world.mission);
    const Objective objective = world.mission.rules.objective;
    return *value(plan.after, objective) / *value(forced.after, objective) - 1;
}

RC_GTEST_PROP(Oracle, ToForceThePlansOwnRemovalsIsNoBetter, ()) {
    const World world = any_world();
    RC_LOG() << picture(world);
    const double loss = loss_to_forced(world);
    RC_CLASSIFY(loss != 0, "another plan");
    RC_ASSERT(loss < 2e-6);
}

TEST(Oracle, ToForceIsNoBetterInTheseWorlds) {
    World best_without_waits = world_of({".....", ".....", "a..b.", "..aa.", ".c..a"}, {1, 1}, {4, 2});
    best_without_waits.mission.rules.removals = 1;
    best_without_waits.mission.agents[0].speed = 2;

    World two_equally_good = world_of({".a..", "b...", ".c.."}, {2, 0}, {0, 2});
    two_equally_good.mission.rules.removals = 1;
    two_equally_good.mission.rules.breach_time.per_obstacle = 1;

    World square_waits_longer = world_of({".ab..", ".ac..", "b..a.", ".cc..", "b..b."}, {1, 4}, {3, 3});
    square_waits_longer.mission.agents[0].speed = 0.5;
    square_waits_longer.mission.agents[1].start = {2, 1};

    for (World world : {best_without_waits, two_equally_good, square_waits_longer}) {
        world.mission.agents[1].speed = 3;
        world.mission.rules.breach_time.per_cell = 0.3;
        EXPECT_LT(loss_to_forced(world), 2e-6) << picture(world);
    }
}

}  // namespace
}  // namespace waybreaker
