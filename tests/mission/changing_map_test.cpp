// A planner whose map changes under it plans as a new one does on a map made from scratch.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "checked_plan.hpp"
#include "random_map.hpp"
#include "waybreaker/map_edit.hpp"

namespace waybreaker {
namespace {

std::vector<Cell> any_cells(const Map& map, const Mission& mission) {
    std::vector<Cell> cells;
    for (int i = *number(1, 8); i > 0; --i) {
        const Cell cell{*number(0, map.width() - 1), *number(0, map.height() - 1)};
        if (cell != mission.agents[0].start && cell != mission.agents[0].goal) cells.push_back(cell);
    }
    return cells;
}

MapEdit any_edit(const Map& map, const Mission& mission) {
    std::vector<ObstacleId> there;
    for (const Obstacle& obstacle : map.obstacles()) {
        if (!obstacle.gone()) there.push_back(obstacle.id);
    }
    const std::vector<Cell> cells = any_cells(map, mission);
    const int kind = *number(0, 3);
    if (kind == 0 && !cells.empty()) return MapEdit::add(cells);
    if (kind == 1 || there.empty()) return MapEdit::free(cells);
    const ObstacleId id = there[std::size_t(*number(0, int(there.size()) - 1))];
    return kind == 2 ? MapEdit::extend(id, cells) : MapEdit::remove(id);
}

bool same_paths(const Plan& one, const Plan& other) {
    return std::ranges::equal(one.agents, other.agents, {}, &Itinerary::path, &Itinerary::path);
}

bool about(std::optional<double> one, std::optional<double> other) {
    return one.has_value() == other.has_value() && (!one || std::abs(*one - *other) <= 1e-9 * std::abs(*one));
}

RC_GTEST_PROP(ChangingMap, PlansAsAMapFromScratch, ()) {
    const PlainMap blocks = *random_map(20, 20);
    RC_PRE(!blocks.free_cells().empty());
    Mission mission = ground_and_air(any_free_cell(blocks), any_free_cell(blocks));
    mission.rules.removals = *number(0, 3);
    mission.rules.breach_time.per_obstacle = *rc::gen::element(0, 2);
    mission.agents[0].body.radius = *rc::gen::element(0.0, 0.5, 0.5);
    Map map(blocks.grid());
    Planner kept;
    for (int edits = *number(1, 4); edits > 0; --edits) {
        map = map.with({any_edit(map, mission)});
        const Plan plan = kept.plan(map, mission);
        RC_ASSERT(plan_faults(map, mission, plan) == "");
        const Plan anew = Planner().plan(map, mission);
        RC_ASSERT(plan.status == anew.status);
        RC_ASSERT(same_paths(plan, anew));
        const Map fresh = Map::from_labels(map.width(), map.height(), {map.labels().begin(), map.labels().end()});
        const Plan same = Planner().plan(fresh, mission);
        RC_ASSERT(plan.status == same.status);
        RC_ASSERT(about(plan.before.makespan, same.before.makespan));
        RC_ASSERT(about(plan.after.makespan, same.after.makespan));
        RC_ASSERT(about(plan.bound, same.bound));
    }
}

RC_GTEST_PROP(ChangingMap, PlansTeamsThatFly, ()) {
    const PlainMap blocks = *random_map(14, 14);
    RC_PRE(blocks.free_cells().size() > 30);
    Mission mission;
    mission.agents = {vehicle("a", any_free_cell(blocks), any_free_cell(blocks)),
                      vehicle("b", any_free_cell(blocks), any_free_cell(blocks)), aircraft("c", {0, 0})};
    mission.rules.at_goal = AtGoal::leave;
    RC_PRE(distance(mission.agents[0].start, mission.agents[1].start) >= 1);
    mission.rules.removals = *number(1, 2);
    Map map(blocks.grid());
    Planner kept;
    for (int edits = *number(1, 3); edits > 0; --edits) {
        const MapEdit edit = any_edit(map, mission);
        const Map next = map.with({edit});
        if (next.grid().blocked(mission.agents[1].start) || next.grid().blocked(mission.agents[1].goal)) continue;
        map = next;
        const Plan plan = kept.plan(map, mission);
        RC_ASSERT(plan_faults(map, mission, plan) == "");
        RC_ASSERT(same_paths(plan, Planner().plan(map, mission)));
    }
}

TEST(ChangingMap, WhatIsGoneCanBeProtectedAndNotForced) {
    const Map map = Map::from_rows({".A.", ".A.", ".A."}).with({MapEdit::remove({1})});
    Mission mission = ground_and_air({0, 1}, {2, 1});
    mission.rules.protect = {{1}};
    EXPECT_TRUE(is_valid(map, mission, Planner().plan(map, mission)));
    mission.rules = {.removals = 1, .force = {{1}}};
    const Expected<Plan> refused = Planner().try_plan(map, mission);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::unknown_obstacle);
    EXPECT_EQ(refused.error().detail, "obstacle 1 must be removed, but is gone");
}

TEST(ChangingMap, WhatIsGoneMayBeSaidToOpenLater) {
    const Map map = Map::from_rows({".A.", ".A.", ".A."}).with({MapEdit::remove({1})});
    Mission mission = ground_and_air({0, 1}, {2, 1});
    mission.rules.opened = {{{1}, 50}};
    for (const int vehicles : {1, 2}) {
        const Plan plan = Planner().plan(map, mission);
        EXPECT_TRUE(is_valid(map, mission, plan)) << vehicles;
        EXPECT_DOUBLE_EQ(*plan.after.ground_makespan, 2) << vehicles;
        mission.agents.push_back(vehicle("other", {0, 0}, {2, 0}));
    }
}

}  // namespace
}  // namespace waybreaker
