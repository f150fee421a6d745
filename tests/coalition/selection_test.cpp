// Every way to select, for several vehicles: by hits, greedily, with proof, not at all.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <map>

#include "any_coalition.hpp"
#include "ascii_map.hpp"
#include "checked_plan.hpp"
#include "waybreaker/advanced/search.hpp"
#include "waybreaker/error.hpp"
#include "waybreaker/planner.hpp"

namespace waybreaker {
namespace {

bool is_possible(const Map& map, const Mission& mission, const Method& method) {
    try {
        validate(map, mission, method);
    } catch (const InputError&) {
        return false;
    }
    return true;
}

// A team of two or more, in which every way to select goes.
Mission any_team(const PlainMap& plain, const Map& map) {
    const Mission mission = any_coalition(plain, map);
    RC_PRE(std::ranges::count(mission.agents, AgentKind::ground, &Agent::kind) > 1);
    RC_PRE(is_possible(map, mission, {.select = Selection::greedy}));
    return mission;
}

double objective(const Mission& mission, const Plan& plan) {
    return *value(plan.after, mission.rules.objective);
}

RC_GTEST_PROP(Selections, KeepToTheRules, ()) {
    const PlainMap plain = *random_map(16, 16);
    const Map map(plain.grid());
    const Mission mission = any_team(plain, map);
    Method method;
    method.select = *rc::gen::element(Selection::hits, Selection::greedy, Selection::none);
    method.bound = *rc::gen::arbitrary<bool>();
    const Plan plan = Planner().plan(map, mission, method);
    RC_TAG(std::to_string(plan.breaches.size()) + " removed");
    RC_ASSERT(plan_faults(map, mission, plan) == "");
    if (plan.status != PlanStatus::solved) return;
    if (method.select != Selection::none) RC_ASSERT(plan.bound.has_value() == method.bound);
    if (plan.bound) RC_ASSERT(*plan.bound <= objective(mission, plan) + 1e-9);
    for (const ObstacleId id : mission.rules.force) {
        RC_ASSERT(std::ranges::count(plan.breaches, id, &Breach::obstacle) == 1);
    }
}

// No way to select has a plan below what is proven for all; so a plan that is proven best is no worse than theirs.
RC_GTEST_PROP(Selections, AreNoBetterThanWhatIsProven, ()) {
    const PlainMap plain = *random_map(16, 16);
    const Map map(plain.grid());
    const Mission mission = any_team(plain, map);
    const Plan exact = Planner().plan(map, mission);
    for (const Selection select : {Selection::hits, Selection::greedy, Selection::none}) {
        Method method;
        method.select = select;
        const Plan plan = Planner().plan(map, mission, method);
        if (plan.status != PlanStatus::solved) continue;
        RC_ASSERT(exact.status == PlanStatus::solved);
        RC_ASSERT(*exact.bound <= objective(mission, plan) + 1e-9);
    }
}

// Nobody gains by the wall alone, but one has to step aside into it for the other; when it opens is ignored.
TEST(Selections, LetVehiclesPastEachOtherWhereNothingIsGained) {
    const Map map = map_from_ascii(R"(
        aa
        a.
        a.
        ..)");
    Mission mission{{vehicle("up", {1, 3}, {1, 1}), vehicle("down", {1, 1}, {1, 2}), aircraft("air", {0, 0})}};
    mission.agents[0].body.radius = 0;
    mission.agents[1].body.radius = 0.2;
    mission.rules.removals = 1;
    mission.rules.timing = Timing::ignore;
    for (const Selection select : {Selection::hits, Selection::exact}) {
        Method method;
        method.select = select;
        const Plan plan = Planner().plan(map, mission, method);
        EXPECT_EQ(plan.status, PlanStatus::solved);
        EXPECT_EQ(plan.breaches.size(), 1U);
    }
}

// Each set that fewer removals allow is one of those that more allow.
RC_GTEST_PROP(Selections, AreNoWorseWithMoreRemovals, ()) {
    const PlainMap plain = *random_map(16, 16);
    const Map map(plain.grid());
    Mission mission = any_team(plain, map);
    Method method;
    method.select = *rc::gen::element(Selection::hits, Selection::greedy);
    // What is hit most is removed whatever it costs, where obstacles do not stand in time.
    if (method.select == Selection::hits) mission.rules.timing = Timing::enforce;
    mission.rules.budget = std::numeric_limits<double>::infinity();
    mission.rules.force.clear();
    std::optional<double> before;
    for (int removals = 0; removals <= 4; ++removals) {
        mission.rules.removals = removals;
        const Plan plan = Planner().plan(map, mission, method);
        if (before) {
            RC_ASSERT(plan.status == PlanStatus::solved);
            RC_ASSERT(objective(mission, plan) <= *before * (1 + 1e-9));
        }
        if (plan.status == PlanStatus::solved) before = objective(mission, plan);
    }
}

// The paper's rule, obstacle by obstacle: hits of all vehicles' searches added up, the most first.
RC_GTEST_PROP(Selections, ByHitsRemoveWhatAllSearchesRanIntoMost, ()) {
    const PlainMap plain = *random_map(16, 16);
    const Map map(plain.grid());
    Mission mission = any_team(plain, map);
    mission.rules.timing = Timing::ignore;
    mission.rules.budget = std::numeric_limits<double>::infinity();
    mission.rules.force.clear();
    for (Agent& agent : mission.agents) agent.breaches = any_number;
    std::map<ObstacleId, std::uint64_t> hits;
    for (const Agent& agent : mission.agents) {
        if (agent.kind == AgentKind::air) continue;
        const SearchOptions counting{.body = agent.body, .count_hits = true};
        const SearchResult search = Searcher().find(OpenedMap(map), agent.start, agent.goal, counting);
        for (const Obstacle& obstacle : map.obstacles()) hits[obstacle.id] += search.hits[obstacle.id.value];
    }
    for (const ObstacleId id : mission.rules.protect) hits.erase(id);
    std::vector<ObstacleId> most;
    for (const auto& [id, count] : hits) {
        if (count > 0) most.push_back(id);
    }
    std::ranges::stable_sort(most, [&](ObstacleId a, ObstacleId b) { return hits[a] > hits[b]; });
    most.resize(std::min(most.size(), std::size_t(mission.rules.removals)));
    std::ranges::sort(most);
    Method method;
    method.select = Selection::hits;
    const Plan plan = Planner().plan(map, mission, method);
    if (plan.status != PlanStatus::solved) return;
    std::vector<ObstacleId> removed;
    for (const Breach& breach : plan.breaches) {
        removed.push_back(breach.obstacle);
        RC_ASSERT(breach.hits == hits[breach.obstacle]);
    }
    std::ranges::sort(removed);
    RC_ASSERT(removed == most);
}

std::vector<ObstacleId> removed_by(const Map& map, const Mission& mission, Selection select) {
    Method method;
    method.select = select;
    const Plan plan = Planner().plan(map, mission, method);
    EXPECT_EQ(plan.status, PlanStatus::solved);
    EXPECT_TRUE(is_valid(map, mission, plan));
    std::vector<ObstacleId> removed;
    for (const Breach& breach : plan.breaches) removed.push_back(breach.obstacle);
    return removed;
}

// None of the upper two gains more by a than the third by b; together they do.
TEST(Selections, GreedilyTakeWhatGainsMostForAllTogether) {
    const std::string_view picture = R"(
        ...........
        ..a........
        ..a........
        ..a........
        ...........
        #########..
        ..b........
        ..b........
        ..b........
        ..b........
        ...........)";
    const Map map = map_from_ascii(picture);
    const auto at = [&](char mark) { return mark_in_ascii(picture, mark); };
    Mission mission;
    mission.rules.objective = Objective::flowtime;
    mission.rules.protect = {map.obstacle_at(at('#'))};
    mission.agents = {vehicle("1", {0, 1}, {4, 1}), vehicle("2", {0, 2}, {4, 2}), vehicle("3", {0, 8}, {4, 8}),
                      aircraft("air", {0, 1}, {0, 1}, 1000)};
    mission.rules.removals = 1;
    EXPECT_EQ(removed_by(map, mission, Selection::greedy), std::vector{map.obstacle_at(at('a'))});
    mission.rules.removals = 2;
    EXPECT_EQ(removed_by(map, mission, Selection::greedy).size(), 2U);
}

// A door behind a door: neither gains alone.
TEST(Selections, GreedilyMissWhatOnlyGainsTogether) {
    const std::string_view picture = R"(
        ..a.b..
        .#####.
        .......
        .......)";
    const Map map = map_from_ascii(picture);
    const auto at = [&](char mark) { return mark_in_ascii(picture, mark); };
    Mission mission;
    mission.rules.objective = Objective::ground_makespan;
    mission.rules.removals = 2;
    mission.rules.protect = {map.obstacle_at(at('#'))};
    mission.agents = {vehicle("1", {0, 0}, {6, 0}), vehicle("2", {0, 3}, {6, 3}),
                      aircraft("air", {0, 0}, {0, 0}, 1000)};
    EXPECT_EQ(removed_by(map, mission, Selection::exact).size(), 2U);
    EXPECT_EQ(removed_by(map, mission, Selection::greedy).size(), 0U);
    mission.rules.force = {map.obstacle_at(at('a'))};
    EXPECT_EQ(removed_by(map, mission, Selection::greedy).size(), 2U);
    EXPECT_EQ(removed_by(map, mission, Selection::none).size(), 1U);
}

}  // namespace
}  // namespace waybreaker
