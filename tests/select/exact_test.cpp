// The proven choice against all sets of obstacles, each planned by itself.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <limits>

#include "ascii_map.hpp"
#include "checked_plan.hpp"
#include "random_map.hpp"
#include "waybreaker/advanced/crossing.hpp"
#include "waybreaker/advanced/schedule.hpp"
#include "waybreaker/planner.hpp"

namespace waybreaker {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

struct World {
    Map map;
    Mission mission;
    Method method;
    Limits limits;
};

World any_world() {
    PlainMap plain = *random_map(12, 12);
    while (Map(plain.grid()).obstacles().size() > 8) plain = *random_map(12, 12);
    World world{Map(plain.grid()), ground_and_air(any_free_cell(plain), any_free_cell(plain)), {}, {}};
    world.mission.rules.removals = *number(0, 3);
    world.mission.rules.objective =
        *rc::gen::element(Objective::makespan, Objective::flowtime, Objective::ground_makespan);
    if (*rc::gen::arbitrary<bool>()) {
        world.mission.agents[1].start = any_cell(plain);
        world.mission.agents[1].goal = any_cell(plain);
        world.mission.agents[1].speed = *rc::gen::element(0.5, 1.0, 2.0);
        world.mission.rules.breach_time = {*rc::gen::element(0.0, 3.0), *rc::gen::element(0.0, 0.25)};
    }
    for (const Obstacle& obstacle : world.map.obstacles()) {
        if (int(world.mission.rules.force.size()) == world.mission.rules.removals) break;
        if (*number(0, 7) == 0) world.mission.rules.force.push_back(obstacle.id);
    }
    return world;
}

double objective(const World& world, const Plan& plan) {
    return value(plan.after, world.mission.rules.objective).value_or(infinity);
}

std::string removed(const Plan& plan) {
    std::string text;
    for (const Breach& breach : plan.breaches) text += " " + std::to_string(breach.obstacle.value);
    return text;
}

// The shortest ground path with exactly these obstacles gone, and the best flight for it.
double cost_of(const World& world, const std::vector<ObstacleId>& removed) {
    const Agent& driver = world.mission.agents[0];
    const Agent& flyer = world.mission.agents[1];
    const CrossingResult path = CrossingSearcher().find(world.map, driver.start, driver.goal, {.removed = removed});
    if (path.status != SearchStatus::found) return infinity;
    const Schedule schedule = best_schedule(world.map, {.ground_path = path.best.path,
                                                        .driver = driver,
                                                        .flyer = flyer,
                                                        .rules = world.mission.rules,
                                                        .removed = removed});
    if (world.mission.rules.objective == Objective::ground_makespan) return schedule.ground.back().t;
    return world.mission.rules.objective == Objective::makespan ? schedule.makespan : schedule.flowtime;
}

// The least cost over all sets of at most rules.removals obstacles that hold those of rules.force.
double least_cost(const World& world) {
    double least = infinity;
    const std::size_t count = world.map.obstacles().size();
    for (std::uint32_t set = 0; set < (1U << count); ++set) {
        std::vector<ObstacleId> removed;
        for (std::uint32_t i = 0; i < count; ++i) {
            if ((set >> i) & 1U) removed.push_back(ObstacleId{i + 1});
        }
        if (!std::ranges::includes(removed, world.mission.rules.force)) continue;
        if (int(removed.size()) <= world.mission.rules.removals) least = std::min(least, cost_of(world, removed));
    }
    return least;
}

RC_GTEST_PROP(ExactChoice, IsAsGoodAsEverySetAndItsBoundHoldsForAll, ()) {
    const World world = any_world();
    const Plan plan = Planner().plan(world.map, world.mission, world.method, world.limits);
    RC_ASSERT(plan_faults(world.map, world.mission, plan) == "");
    const double least = least_cost(world);
    RC_ASSERT((plan.status == PlanStatus::solved) == (least < infinity));
    if (plan.status != PlanStatus::solved) return;
    RC_ASSERT(plan.bound.has_value());
    RC_ASSERT(*plan.bound <= least * (1 + 1e-9));
    // Of equally short ground paths one may enter an obstacle later and wait less than the other.
    const double waits = *plan.after.makespan - *plan.after.ground().length / world.mission.agents[0].speed;
    RC_ASSERT(objective(world, plan) <= least + std::max(waits, 0.0) + 1);
}

// The lemma: with equal speeds and ends the ground path decides, but for the breach points being cells.
RC_GTEST_PROP(ExactChoice, EndsWithTheShortestCrossingPath, ()) {
    World world = any_world();
    world.mission.agents[1] = {"air", AgentKind::air, world.mission.agents[0].start, world.mission.agents[0].goal, 1};
    world.mission.rules.breach_time = {};
    world.mission.rules.objective = Objective::makespan;
    world.mission.rules.force = {};
    const Plan plan = Planner().plan(world.map, world.mission, world.method, world.limits);
    const Agent& driver = world.mission.agents[0];
    const CrossingResult path =
        CrossingSearcher().find(world.map, driver.start, driver.goal, {.crossings = world.mission.rules.removals});
    RC_ASSERT((plan.status == PlanStatus::solved) == (path.status == SearchStatus::found));
    if (plan.status != PlanStatus::solved) return;
    RC_ASSERT(*plan.after.makespan >= path.best.length / 1.0824);  // the disc is slimmer than the square
    RC_ASSERT(*plan.after.makespan <= path.best.length + 1.5 * world.mission.rules.removals + 1e-9);
}

RC_GTEST_PROP(ExactChoice, MoreRemovalsNeverCostMoreAndTheFrontSaysSo, ()) {
    World world = any_world();
    const std::vector<Plan> front = Planner().front(world.map, world.mission, world.method, world.limits);
    RC_ASSERT(!front.empty());
    for (std::size_t n = 1; n < front.size(); ++n) {
        RC_ASSERT(objective(world, front[n]) <= objective(world, front[n - 1]) * (1 + 1e-9));
    }
    const double reached = objective(world, front.back());
    world.mission.rules.removals = int(front.size() + world.mission.rules.force.size()) - 1;
    RC_ASSERT(objective(world, Planner().plan(world.map, world.mission, world.method, world.limits)) == reached);
}

TEST(ExactChoice, FrontGoesOnWhereOnlyManyRemovalsGainTogether) {
    const Map map = map_from_ascii(R"(
        ....a.b.c.d....
        .wwwwwwwwwwwww.
        ...............)");
    Mission mission = ground_and_air({0, 0}, {14, 0});
    mission.rules = {.removals = 32, .protect = {map.obstacle_at({1, 1})}};
    const std::vector<Plan> front = Planner().front(map, mission);
    ASSERT_EQ(front.size(), 5U);
    EXPECT_GT(*front[3].after.makespan, 16);
    EXPECT_NEAR(*front[4].after.makespan, 14, 1e-9);
    mission.rules.removals = 3;
    EXPECT_EQ(Planner().front(map, mission).size(), 1U) << "three gain nothing";
    mission.rules.removals = 4;
    EXPECT_EQ(Planner().front(map, mission).size(), 5U);
}

RC_GTEST_PROP(ExactChoice, ExplainsWhatEachRemovalSaves, ()) {
    World world = any_world();
    world.method.explain = true;
    const Plan plan = Planner().plan(world.map, world.mission, world.method, world.limits);
    if (plan.status != PlanStatus::solved) return;
    for (const Breach& breach : plan.breaches) {
        World without = world;
        without.method.explain = false;
        without.mission.rules.protect.push_back(breach.obstacle);
        std::erase(without.mission.rules.force, breach.obstacle);
        const Plan other = Planner().plan(world.map, without.mission, without.method);
        const double cost = objective(without, other);
        RC_LOG() << "objective " << objective(world, plan) << ", bound " << *plan.bound << ", removed" << removed(plan)
                 << "; without " << breach.obstacle.value << " " << cost << ", removed" << removed(other) << "\n";
        RC_ASSERT(breach.saves.has_value());
        const bool forced = std::ranges::count(world.mission.rules.force, breach.obstacle) > 0;
        // Less than nothing only where the gap says that there may be a better plan.
        RC_ASSERT(forced || *breach.saves >= *plan.bound - objective(world, plan) - 1e-9);
        RC_ASSERT(cost == infinity || std::abs(cost - objective(world, plan) - *breach.saves) < 1e-6);
    }
}

RC_GTEST_PROP(ExactChoice, ReportsProgressAsItIsMade, ()) {
    World world = any_world();
    world.method.explain = *rc::gen::arbitrary<bool>();  // which plans more, and says nothing of it
    std::vector<Progress> reported;
    world.limits.progress = [&reported](const Progress& progress) { reported.push_back(progress); };
    const Plan plan = Planner().plan(world.map, world.mission, world.method, world.limits);
    RC_ASSERT(!reported.empty());
    for (std::size_t i = 1; i < reported.size(); ++i) {
        RC_ASSERT(reported[i].best <= reported[i - 1].best);
        RC_ASSERT(reported[i].bound >= reported[i - 1].bound);
    }
    RC_ASSERT(reported.back().best == objective(world, plan));
    if (plan.status == PlanStatus::solved)
        RC_ASSERT(std::min(reported.back().bound, reported.back().best) == *plan.bound);
}

// Of a search that may expand little, or is out of time at once.
RC_GTEST_PROP(ExactChoice, HoldsWhatItProvedWhenStopped, ()) {
    World world = any_world();
    if (*number(0, 3) == 0) {
        world.limits.seconds = 1e-9;
    } else {
        world.limits.expansions = std::uint64_t(*number(1, 30));
    }
    const Plan plan = Planner().plan(world.map, world.mission, world.method, world.limits);
    if (plan.status != PlanStatus::solved) return;
    RC_ASSERT(plan_faults(world.map, world.mission, plan) == "");
    RC_ASSERT(plan.bound.has_value());
    RC_ASSERT(*plan.bound <= least_cost(world) * (1 + 1e-9));
    RC_ASSERT(*plan.bound <= objective(world, plan) * (1 + 1e-9));
    const Plan again = Planner().plan(world.map, world.mission, world.method, world.limits);
    RC_ASSERT(again.bound == plan.bound);
    for (std::size_t i = 0; i < plan.agents.size(); ++i) RC_ASSERT(again.agents[i].path == plan.agents[i].path);
}

RC_GTEST_PROP(ExactChoice, SaysSoWhenALimitCostsTime, ()) {
    World world = any_world();
    const Plan whole = Planner().plan(world.map, world.mission, world.method, world.limits);
    world.limits.expansions = std::uint64_t(*number(1, 30));
    const Plan plan = Planner().plan(world.map, world.mission, world.method, world.limits);
    if (plan.status != whole.status) RC_ASSERT(plan.limit_reached);
    if (plan.status != PlanStatus::solved) return;
    RC_TAG(plan.limit_reached);
    if (objective(world, plan) > objective(world, whole) * (1 + 1e-9)) RC_ASSERT(plan.limit_reached);
    constexpr double never = std::numeric_limits<double>::infinity();
    const double before = whole.before.makespan.value_or(never);
    if (plan.before.makespan.value_or(never) > before * (1 + 1e-9)) RC_ASSERT(plan.limit_reached);
}

TEST(ExactChoice, OpensWhatIsMostInTheWayWhenOutOfTime) {
    const Map map = map_from_ascii(R"(
        ..a....
        ..a.b..
        ..a....)");
    Mission mission = ground_and_air({0, 1}, {6, 1});
    mission.rules.removals = 1;
    const Plan plan = Planner().plan(map, mission, {}, {.seconds = 1e-9});
    EXPECT_TRUE(is_valid(map, mission, plan));
    ASSERT_EQ(plan.breaches.size(), 1U);
    EXPECT_EQ(plan.breaches[0].obstacle, map.obstacle_at({2, 0}));
    EXPECT_DOUBLE_EQ(plan.bound.value(), 6);  // the straight line
}

// The search that would prove it ends before it has seen any way.
TEST(ExactChoice, OpensWhatIsHitMostWhereTheProofIsCut) {
    const Map map = map_from_ascii(R"(
        ........
        a.b.....
        ....c...
        d..cc.e.
        .....f..)");
    Mission mission = ground_and_air({6, 4}, {0, 0});
    mission.rules.removals = 2;
    const Plan plan = Planner().plan(map, mission, {}, {.expansions = 5});
    EXPECT_TRUE(is_valid(map, mission, plan));
    EXPECT_EQ(plan.status, PlanStatus::solved);
    EXPECT_TRUE(plan.limit_reached);
}

// A point slips between all these cells, a disc does not: the square's path proves more.
TEST(ExactSelection, BoundsTheDiscWhereAPointSlipsThrough) {
    const Map map = map_from_ascii(R"(
        ..........
        .#.#.#.#..
        #.#.#.#.#.
        .#.#.#.#..
        #.#.#.#.#.
        .#.#.#.#..
        ..........)");
    Mission mission = ground_and_air({0, 0}, {8, 6});
    for (const Obstacle& obstacle : map.obstacles()) mission.rules.protect.push_back(obstacle.id);
    mission.rules.removals = 1;
    const Plan plan = Planner().plan(map, mission);
    EXPECT_TRUE(is_valid(map, mission, plan));
    EXPECT_GT(*plan.gap, 0.05);
    EXPECT_LT(*plan.gap, 0.0824);

    // Where nothing may be removed, all cell centres are looked at.
    mission.rules.removals = 0;
    const Plan closed = Planner().plan(map, mission);
    EXPECT_EQ(closed.after.makespan, plan.after.makespan);
    EXPECT_EQ(*closed.gap, 0);
}

// To force what would be chosen anyway changes nothing, nor does what must go beside it.
TEST(ExactChoice, DrivesThroughWhatIsForcedWhenItOpens) {
    const Map both = map_from_ascii(R"(
        a..
        .bb
        .a.)");
    Mission mission = ground_and_air({1, 0}, {0, 2});
    mission.agents[1].goal = {2, 0};
    mission.rules = {.removals = 2, .breach_time = {1, 0}};
    const double chosen = *Planner().plan(both, mission).after.makespan;
    mission.rules.force = {both.obstacle_at({1, 1}), both.obstacle_at({0, 0})};
    EXPECT_DOUBLE_EQ(*Planner().plan(both, mission).after.makespan, chosen);

    const Map beside = map_from_ascii(R"(
        a.bb
        aac.)");
    mission = ground_and_air({3, 1}, {1, 0});
    mission.agents[1] = {.id = "air", .kind = AgentKind::air, .start = {0, 1}, .goal = {2, 0}, .speed = 5};
    mission.rules = {.removals = 2, .breach_time = {2.5, 0.3}};
    mission.rules.protect = {beside.obstacle_at({0, 0})};
    mission.rules.force = {beside.obstacle_at({2, 1})};
    const Plan plan = Planner().plan(beside, mission);
    ASSERT_TRUE(is_valid(beside, mission, plan));
    EXPECT_LT(*plan.after.makespan, 6.4);  // through b while c is still to go
}

}  // namespace
}  // namespace waybreaker
