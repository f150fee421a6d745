// Coalitions: vehicles for which aircraft remove obstacles. Judge and simulation pass every plan.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <set>

#include "any_coalition.hpp"
#include "ascii_map.hpp"
#include "checked_plan.hpp"
#include "random_map.hpp"
#include "select/tuning.hpp"
#include "team/simulation.hpp"
#include "vehicle.hpp"
#include "waybreaker/error.hpp"
#include "waybreaker/planner.hpp"

namespace waybreaker {
namespace {

RC_GTEST_PROP(Coalition, PlansAreValid, ()) {
    const PlainMap plain = *random_map(16, 16);
    const Map map(plain.grid());
    Mission mission = any_coalition(plain, map);
    try {
        validate(map, mission, {});
    } catch (const InputError&) {
        mission.rules.force.clear();
    }
    Method method;
    const bool drives_alone = std::ranges::count(mission.agents, AgentKind::ground, &Agent::kind) == 1;
    if (drives_alone) method.select = *rc::gen::element(Selection::exact, Selection::hits, Selection::none);
    method.bound = true;
    const Plan plan = Planner().plan(map, mission, method);
    RC_TAG(plan.status == PlanStatus::solved ? "solved" : "not solved");
    RC_TAG(std::to_string(plan.breaches.size()) + " removed");
    RC_ASSERT(plan_faults(map, mission, plan) == "");
    if (plan.status != PlanStatus::solved) return;
    RC_ASSERT(*plan.bound <= *value(plan.after, mission.rules.objective) + 1e-9);
    const auto cuts_corners = [](const Agent& a) { return a.body.corners != Corners::none; };
    if (std::ranges::none_of(mission.agents, cuts_corners)) RC_ASSERT(simulate(map, mission, plan, 0.05) == "");
}

// The best of all that may be removed, and of less: where no limit ends it, more may not make a plan worse. For one
// vehicle the choice ends at a gap that is small enough, so by no more than that.
RC_GTEST_PROP(Coalition, IsNoWorseWithMoreRemovals, ()) {
    const PlainMap plain = *random_map(16, 16);
    const Map map(plain.grid());
    Mission mission = any_coalition(plain, map);
    mission.rules.force.clear();
    const Objective objective = mission.rules.objective;
    const bool drives_alone = std::ranges::count(mission.agents, AgentKind::ground, &Agent::kind) == 1;
    std::optional<double> before;
    for (int removals = 0; removals <= 4; ++removals) {
        mission.rules.removals = removals;
        const Plan plan = Planner().plan(map, mission);
        RC_LOG() << removals << " removals: " << value(plan.after, objective).value_or(-1) << '\n';
        if (before) {
            RC_ASSERT(plan.status == PlanStatus::solved);
            const bool is_proven = plan.gap.value_or(1) <= 1e-9;
            const double enough = drives_alone && !is_proven ? tuning::enough_in_time : 1e-9;
            RC_ASSERT(*value(plan.after, objective) <= *before * (1 + enough));
            RC_ASSERT(*plan.bound <= *value(plan.after, objective) + 1e-9);
        }
        if (plan.status == PlanStatus::solved) before = value(plan.after, objective);
    }
}

// Two change places past a third in a dead end. Removing the wall at one end is enough, where removed walls never
// stood.
TEST(Coalition, RemovesNoMoreThanItTakesToGetPast) {
    std::vector<std::string> rows(16, "A");
    rows[0] = "B";
    rows[1] = rows[2] = rows[3] = ".";
    const Map map = Map::from_rows(rows);
    Mission mission;
    mission.agents = {aircraft("bird", {0, 8}, {0, 12}), vehicle("1", {0, 2}, {0, 2}), vehicle("2", {0, 3}, {0, 1}),
                      vehicle("3", {0, 1}, {0, 3})};
    mission.agents[0].speed = 3;
    mission.agents[2].body.radius = 0;
    mission.rules.at_goal = AtGoal::leave;
    mission.rules.timing = Timing::ignore;
    mission.rules.breach_time.per_cell = 0.5;
    mission.rules.removals = 1;
    const Plan one = Planner().plan(map, mission);
    mission.rules.removals = 2;
    const Plan two = Planner().plan(map, mission);
    ASSERT_EQ(one.status, PlanStatus::solved);
    ASSERT_EQ(two.status, PlanStatus::solved);
    EXPECT_TRUE(is_valid(map, mission, two));
    EXPECT_LE(*two.after.makespan, *one.after.makespan * (1 + 1e-9));
}

// A set that has to be removed gets no more care than one that was chosen.
RC_GTEST_PROP(Coalition, IsNoWorseThanWithItsOwnSetForced, ()) {
    const PlainMap plain = *random_map(16, 16);
    const Map map(plain.grid());
    Mission mission = any_coalition(plain, map);
    mission.rules.force.clear();
    const Objective objective = mission.rules.objective;
    const Plan plan = Planner().plan(map, mission);
    if (plan.status != PlanStatus::solved) return;
    for (const Breach& breach : plan.breaches) mission.rules.force.push_back(breach.obstacle);
    std::ranges::sort(mission.rules.force);
    mission.rules.removals = int(mission.rules.force.size());
    const Plan alone = Planner().plan(map, mission);
    if (alone.status != PlanStatus::solved) return;
    RC_ASSERT(*value(plan.after, objective) <= *value(alone.after, objective) * (1 + 1e-9));
}

TEST(Coalition, OpensAWallForTwo) {
    const Map map = map_from_ascii(R"(
        .........
        .#######.
        .........
        .........)");
    Mission mission;
    mission.rules.objective = Objective::flowtime;
    mission.rules.removals = 1;
    mission.agents = {vehicle("a", {3, 0}, {3, 2}), vehicle("b", {5, 0}, {5, 2}), aircraft("air", {4, 0}, {4, 0})};
    const Plan plan = Planner().plan(map, mission);
    ASSERT_EQ(plan.status, PlanStatus::solved);
    EXPECT_TRUE(is_valid(map, mission, plan));
    ASSERT_EQ(plan.breaches.size(), 1U);
    EXPECT_EQ(plan.breaches[0].by, "air");
    EXPECT_DOUBLE_EQ(*plan.after.flowtime, 4);
    EXPECT_DOUBLE_EQ(*plan.bound, 4);
}

const Map& two_walls() {
    static const Map map = map_from_ascii(R"(
        ...a...b...
        ...a...b...
        ...a...b...
        ...a...b...)");
    return map;
}

Mission through_two_walls() {
    Mission mission;
    mission.rules.objective = Objective::flowtime;
    mission.agents = {vehicle("up", {0, 0}, {10, 0}), vehicle("down", {0, 3}, {10, 3}),
                      aircraft("west", {0, 2}, {0, 2}), aircraft("east", {10, 2}, {10, 2})};
    return mission;
}

std::set<std::string> breachers(const Plan& plan) {
    std::set<std::string> ids;
    for (const Breach& breach : plan.breaches) ids.insert(breach.by);
    return ids;
}

TEST(Coalition, SharesBreachesOut) {
    Mission mission = through_two_walls();
    mission.rules.breach_time.per_obstacle = 3;
    const Plan plan = Planner().plan(two_walls(), mission);
    ASSERT_EQ(plan.status, PlanStatus::solved);
    EXPECT_TRUE(is_valid(two_walls(), mission, plan));
    EXPECT_FALSE(plan.before.makespan.has_value());
    EXPECT_EQ(breachers(plan), (std::set<std::string>{"east", "west"}));
    mission.agents[3].breaches = 0;
    const Plan alone = Planner().plan(two_walls(), mission);
    ASSERT_EQ(alone.status, PlanStatus::solved);
    EXPECT_TRUE(is_valid(two_walls(), mission, alone));
    EXPECT_EQ(breachers(alone), std::set<std::string>{"west"});
    EXPECT_GT(*alone.after.flowtime, *plan.after.flowtime);
}

TEST(Coalition, HasNoPlanWhereNotEnoughMayBeRemoved) {
    Mission mission = through_two_walls();
    mission.rules.removals = 1;
    EXPECT_EQ(Planner().plan(two_walls(), mission).status, PlanStatus::no_plan);
    mission.rules.removals = 2;
    mission.agents[2].breaches = mission.agents[3].breaches = 0;
    EXPECT_EQ(Planner().plan(two_walls(), mission).status, PlanStatus::no_plan);
    mission.agents[2].breaches = 2;
    mission.rules.protect = {{1}};
    EXPECT_EQ(Planner().plan(two_walls(), mission).status, PlanStatus::no_plan);
}

// Vehicles that hinder each other: the set that is best for each alone is not the best for all.
TEST(Coalition, TriesFewerRemovalsThanAircraftCanBreach) {
    const Map map = map_from_ascii(R"(
        a.aa.b
        aaa.bb
        .....b
        ..c...)");
    Mission mission;
    mission.agents = {vehicle("slow", {0, 2}, {3, 2}), vehicle("a", {3, 1}, {1, 3}),
                      vehicle("point", {1, 2}, {4, 2}, 0), vehicle("parked", {4, 0}, {4, 0}),
                      aircraft("air", {0, 0}, {1, 2})};
    mission.agents[0].speed = 0.5;
    mission.agents[3].body = {.corners = Corners::cut};
    mission.agents[4].breaches = 2;
    mission.rules.objective = Objective::flowtime;
    mission.rules.timing = Timing::ignore;
    mission.rules.separation = 0.5;
    mission.rules.removals = 1;
    const Plan one = Planner().plan(map, mission);
    mission.rules.removals = 4;
    const Plan four = Planner().plan(map, mission);
    ASSERT_EQ(one.status, PlanStatus::solved);
    ASSERT_EQ(four.status, PlanStatus::solved);
    EXPECT_LE(*four.after.flowtime, *one.after.flowtime * (1 + 1e-9));
}

TEST(Coalition, RemovesWhatItMust) {
    const Map map = map_from_ascii(R"(
        .....
        .....
        ..a..
        .....)");
    Mission mission;
    mission.agents = {vehicle("a", {0, 0}, {4, 0}), vehicle("b", {4, 1}, {0, 1}), aircraft("air", {0, 0}, {0, 0}, 2)};
    mission.rules.force = {{1}};
    const Plan plan = Planner().plan(map, mission);
    ASSERT_EQ(plan.status, PlanStatus::solved);
    EXPECT_TRUE(is_valid(map, mission, plan));
    EXPECT_EQ(plan.breaches.size(), 1U);
    mission.agents[2].breaches = 0;
    EXPECT_THROW(Planner().plan(map, mission), InputError);
}

TEST(Coalition, IsPlannedTheSameEachTime) {
    const Mission mission = through_two_walls();
    Planner used;
    const Plan first = used.plan(two_walls(), mission);
    ASSERT_EQ(first.status, PlanStatus::solved);
    for (const Plan& again : {used.plan(two_walls(), mission), Planner().plan(two_walls(), mission)}) {
        EXPECT_EQ(again.bound, first.bound);
        for (std::size_t i = 0; i < first.agents.size(); ++i) EXPECT_EQ(again.agents[i].path, first.agents[i].path);
    }
}

// Not even in how much work it was, wherever a limit ends a search.
RC_GTEST_PROP(Coalition, IsPlannedTheSameAgainAndByAnyNumberOfThreads, ()) {
    const PlainMap plain = *random_map(20, 20);
    const Map map(plain.grid());
    const Mission mission = any_coalition(plain, map);
    Limits limits{.expansions = *rc::gen::element<std::uint64_t>(10, 100, UINT64_MAX, UINT64_MAX)};
    try {
        validate(map, mission, {}, limits);
    } catch (const InputError&) {
        RC_DISCARD();
    }
    Planner planner;
    const Plan first = planner.plan(map, mission, {}, limits);
    const Plan again = planner.plan(map, mission, {}, limits);
    limits.threads = unsigned(*number(2, 4));
    const Plan by_many = Planner().plan(map, mission, {}, limits);
    for (const Plan* other : {&again, &by_many}) {
        RC_ASSERT(other->status == first.status);
        RC_ASSERT(other->bound == first.bound);
        RC_ASSERT(other->limit_reached == first.limit_reached);
        RC_ASSERT(other->after.flowtime == first.after.flowtime);
        RC_ASSERT(other->agents.size() == first.agents.size());
        for (std::size_t i = 0; i < first.agents.size(); ++i) RC_ASSERT(other->agents[i].path == first.agents[i].path);
        RC_ASSERT(other->after.routes.size() == first.after.routes.size());
        for (std::size_t i = 0; i < first.after.routes.size(); ++i) {
            RC_ASSERT(other->after.routes[i].expanded == first.after.routes[i].expanded);
            RC_ASSERT(other->after.routes[i].generated == first.after.routes[i].generated);
        }
    }
}

TEST(Coalition, StopsInTime) {
    const Mission mission = through_two_walls();
    StopSource source;
    source.request_stop();
    const Plan stopped = Planner().plan(two_walls(), mission, {}, {.stop = source.get_token()});
    EXPECT_NE(stopped.status, PlanStatus::no_plan);
    EXPECT_EQ(plan_faults(two_walls(), mission, stopped), "");
    const Plan hasty = Planner().plan(two_walls(), mission, {}, {.expansions = 1});
    EXPECT_NE(hasty.status, PlanStatus::no_plan);
    EXPECT_EQ(plan_faults(two_walls(), mission, hasty), "");
}

TEST(Coalition, GainsWithEachRemoval) {
    Mission mission = through_two_walls();
    const std::vector<Plan> front = Planner().front(two_walls(), mission);
    ASSERT_EQ(front.size(), 3U);  // nobody arrives with less than two
    EXPECT_EQ(front[1].status, PlanStatus::no_plan);
    EXPECT_EQ(front[2].status, PlanStatus::solved);
}

RC_GTEST_PROP(Coalition, CurveNeverGoesUp, ()) {
    const PlainMap plain = *random_map(16, 16);
    const Map map(plain.grid());
    Mission mission = any_coalition(plain, map);
    mission.rules.force.clear();
    const std::vector<Plan> front = Planner().front(map, mission);
    for (std::size_t n = 0; n < front.size(); ++n) {
        mission.rules.removals = int(n);
        RC_ASSERT(plan_faults(map, mission, front[n]) == "");
        if (n == 0 || front[n - 1].status != PlanStatus::solved) continue;
        RC_ASSERT(front[n].status == PlanStatus::solved);
        RC_ASSERT(*value(front[n].after, mission.rules.objective) <=
                  *value(front[n - 1].after, mission.rules.objective));
    }
}

// The first aircraft is the nearest to an obstacle that another one has to breach.
TEST(Coalition, GivesAFewBreachesToTheRightAircraft) {
    const Map map = map_from_ascii(R"(
        ......#.#..#.#.##..#...#.
        .#..##...##.....##.....##
        .###.#....#..###..##....#
        .#####..#..#..###.....##.
        .#.#.##.....##.....#.##..
        .#.#.#..##.##.###....##..
        ###.#..#..#.......##.#..#
        ...#...#.....#.#..###....)");
    Mission mission{{vehicle("v0", {24, 5}, {8, 7}), vehicle("v1", {0, 5}, {21, 2}), vehicle("v2", {6, 2}, {1, 0}),
                     vehicle("v3", {7, 0}, {18, 5}), aircraft("a0", {22, 2}, {2, 4}), aircraft("a1", {10, 0}, {0, 2}),
                     aircraft("a2", {24, 3}, {2, 0})}};
    constexpr std::array speeds{1.0, 3.0, 0.5, 1.0, 2.0, 0.7, 0.7};
    for (std::size_t i = 0; i < speeds.size(); ++i) mission.agents[i].speed = speeds[i];
    mission.agents[1].ready_at = 2.3;
    mission.agents[4].breaches = 1;
    mission.rules.removals = 3;
    mission.rules.objective = Objective::flowtime;
    const Plan plan = Planner().plan(map, mission);
    ASSERT_TRUE(is_valid(map, mission, plan));
    EXPECT_LT(*plan.after.flowtime, 119);  // 131 if it breaches that one
}

}  // namespace
}  // namespace waybreaker
