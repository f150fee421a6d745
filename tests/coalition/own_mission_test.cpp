// One vehicle's mission beside others: who needs nothing changes nothing of what is chosen for those who do.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <string>

#include "any_coalition.hpp"
#include "ascii_map.hpp"
#include "checked_plan.hpp"
#include "coalition/tuning.hpp"
#include "waybreaker/planner.hpp"

namespace waybreaker {
namespace {

// A free cell with a free one beside it, to the right.
std::optional<Cell> any_pair_of_cells(const Map& map) {
    std::vector<Cell> cells;
    for (Cell c; c.y < map.height(); ++c.y) {
        for (c.x = 0; c.x + 1 < map.width(); ++c.x) {
            if (!map.grid().blocked(c) && !map.grid().blocked({c.x + 1, c.y})) cells.push_back(c);
        }
    }
    if (cells.empty()) return std::nullopt;
    return cells[std::size_t(*number(0, int(cells.size()) - 1))];
}

// One vehicle and its aircraft; nobody is in anybody's way.
Mission any_mission_of_one(const PlainMap& plain, const Map& map) {
    Mission mission = any_coalition(plain, map);
    mission.rules.collisions = false;
    mission.rules.separation = 0;
    mission.rules.force.clear();
    const auto first = std::ranges::find(mission.agents, AgentKind::ground, &Agent::kind);
    const Agent driver = *first;
    // A point of a team bends at cell centres, and of a small disc several paths are nearly as good.
    RC_PRE(driver.body.corners == Corners::none && driver.body.radius > 0.3);
    std::erase_if(mission.agents, [](const Agent& agent) { return agent.kind == AgentKind::ground; });
    mission.agents.push_back(driver);
    return mission;
}

// The sorties that insertion and exchange find end at 4.
TEST(OwnMission, LendsItsSorties) {
    const Map map = map_from_ascii("..aa.b.ccc");
    Mission mission{
        {vehicle("one", {6, 0}, {0, 0}), aircraft("slow", {5, 0}, {7, 0}), aircraft("fast", {6, 0}, {0, 0}, 3)}};
    mission.agents[0].speed = 3;
    mission.agents[2].breaches = 1;
    mission.rules.removals = 2;
    mission.rules.collisions = false;
    EXPECT_DOUBLE_EQ(*Planner().plan(map, mission).after.makespan, 3);
    mission.agents.push_back(vehicle("other", {0, 0}, {1, 0}));
    const Plan plan = Planner().plan(map, mission);
    EXPECT_DOUBLE_EQ(*plan.after.makespan, 3);
    EXPECT_EQ(plan_faults(map, mission, plan), "");
}

RC_GTEST_PROP(OwnMission, WhoNeedsNothingChangesNothing, ()) {
    const PlainMap plain = *random_map(16, 16);
    const Map map(plain.grid());
    const Mission alone = any_mission_of_one(plain, map);
    const std::optional<Cell> at = any_pair_of_cells(map);
    RC_PRE(at.has_value());
    Mission both = alone;
    both.agents.push_back(vehicle("near", *at, {at->x + 1, at->y}, 0));
    const Plan one = Planner().plan(map, alone);
    const Plan two = Planner().plan(map, both);
    RC_ASSERT(plan_faults(map, both, two) == "");
    RC_ASSERT((one.status == PlanStatus::solved) == (two.status == PlanStatus::solved));
    if (one.status != PlanStatus::solved) return;
    const Objective objective = alone.rules.objective;
    const double more = objective == Objective::flowtime ? 1 : 0;
    const double reached = std::max(*value(one.after, objective) + more, objective == Objective::flowtime ? 0.0 : 1.0);
    RC_TAG(one.breaches.empty() ? "nothing removed" : "removed");
    RC_ASSERT(*value(two.after, objective) <= reached * (1 + coalition::tuning::gap_for_own_mission));
    RC_ASSERT(*two.bound <= *value(two.after, objective) + 1e-9);
    if (*two.gap > coalition::tuning::gap_for_own_mission) RC_ASSERT(*two.bound >= *one.bound + more - 1e-9);
}

}  // namespace
}  // namespace waybreaker
