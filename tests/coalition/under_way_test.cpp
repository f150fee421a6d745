// Teams whose agents are under way already, and obstacles that open by themselves.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "any_coalition.hpp"
#include "ascii_map.hpp"
#include "checked_plan.hpp"
#include "random_map.hpp"
#include "team/simulation.hpp"
#include "vehicle.hpp"
#include "waybreaker/map_edit.hpp"
#include "waybreaker/planner.hpp"

namespace waybreaker {
namespace {

constexpr double after_all = 1e6;

double reached(const Mission& mission, const Plan& plan) {
    return value(plan.after, mission.rules.objective).value_or(std::numeric_limits<double>::infinity());
}

void set_out(const Map& map, Mission& mission) {
    for (Agent& agent : mission.agents) {
        if (agent.kind == AgentKind::air) {
            agent.ready_at = *rc::gen::element(0.0, 2.0, 7.0);
            const bool aside = *rc::gen::arbitrary<bool>();
            if (aside && agent.start.x + 1 < map.width()) agent.from = Point(agent.start.x + 0.4, agent.start.y);
        }
        if (agent.ready_at == 0 || *rc::gen::arbitrary<bool>()) continue;
        const Point start = agent.begin();
        agent.approach = {{start.x, start.y, agent.ready_at / 2}, {start.x, start.y, agent.ready_at}};
    }
}

void open_some(const Map& map, Mission& mission) {
    for (const ObstacleId id : some_obstacles(map, 4)) {
        std::vector<TimedOpening>& opened = mission.rules.opened;
        const bool known = std::ranges::find(opened, id, &TimedOpening::obstacle) != opened.end();
        if (known || std::ranges::count(mission.rules.force, id) > 0) continue;
        opened.push_back({id, *rc::gen::element(0.0, 2.0, 8.0, 30.0, after_all)});
    }
}

struct Team {
    Map map;
    Mission mission;
};

Team any_team() {
    const PlainMap plain = *random_map(16, 16);
    Map map(plain.grid());
    Mission mission = any_coalition(plain, map);
    mission.rules.force.clear();
    if (*number(0, 4) == 0) std::erase_if(mission.agents, [](const Agent& a) { return a.kind == AgentKind::air; });
    return {std::move(map), std::move(mission)};
}

RC_GTEST_PROP(TeamsUnderWay, PlansAreValid, ()) {
    Team team = any_team();
    set_out(team.map, team.mission);
    open_some(team.map, team.mission);
    Method method;
    method.select = *rc::gen::element(Selection::exact, Selection::exact, Selection::hits, Selection::none);
    method.bound = true;
    method.explain = *number(0, 3) == 0;
    const Plan plan = Planner().plan(team.map, team.mission, method);
    RC_TAG(plan.status == PlanStatus::solved ? "solved" : "not solved");
    RC_ASSERT(plan_faults(team.map, team.mission, plan) == "");
    if (plan.status != PlanStatus::solved) return;
    if (plan.bound) RC_ASSERT(*plan.bound <= reached(team.mission, plan) + 1e-9);
    const auto cuts_corners = [](const Agent& a) { return a.body.corners != Corners::none; };
    if (std::ranges::none_of(team.mission.agents, cuts_corners))
        RC_ASSERT(simulate(team.map, team.mission, plan, 0.05) == "");
}

RC_GTEST_PROP(TeamsUnderWay, AnOpeningAtZeroIsAMapWithoutTheObstacle, ()) {
    Team team = any_team();
    RC_PRE(!team.map.obstacles().empty());
    const ObstacleId id{std::uint32_t(*number(1, int(team.map.obstacles().size())))};
    Team without{team.map.with(std::vector{MapEdit::remove(id)}), team.mission};
    team.mission.rules.opened = {{id, 0}};
    const Plan plan = Planner().plan(team.map, team.mission);
    const Plan same = Planner().plan(without.map, without.mission);
    RC_ASSERT(plan.status == same.status);
    if (plan.status != PlanStatus::solved) return;
    RC_ASSERT(plan_faults(team.map, team.mission, plan) == "");
    RC_ASSERT(reached(team.mission, plan) == reached(without.mission, same));
    RC_ASSERT(plan.bound == same.bound);
}

// Where timing is ignored nobody waits for what opens by itself, whenever that is.
RC_GTEST_PROP(TeamsUnderWay, WhenAnObstacleOpensIsIgnoredWithTheTiming, ()) {
    Team team = any_team();
    RC_PRE(!team.map.obstacles().empty());
    team.mission.rules.timing = Timing::ignore;
    const ObstacleId id{std::uint32_t(*number(1, int(team.map.obstacles().size())))};
    team.mission.rules.opened = {{id, 0}};
    const Plan early = Planner().plan(team.map, team.mission);
    team.mission.rules.opened = {{id, after_all}};
    const Plan late = Planner().plan(team.map, team.mission);
    RC_ASSERT(late.status == early.status);
    RC_ASSERT(plan_faults(team.map, team.mission, late) == "");
    RC_ASSERT(reached(team.mission, late) == reached(team.mission, early));
}

// Where a plan is proven to be the best, none is better with an obstacle that opens too late, or later.
RC_GTEST_PROP(TeamsUnderWay, ALateOpeningIsNeverBetter, ()) {
    Team team = any_team();
    RC_PRE(!team.map.obstacles().empty());
    team.mission.rules.timing = Timing::enforce;
    const ObstacleId id{std::uint32_t(*number(1, int(team.map.obstacles().size())))};
    Team standing = team;
    standing.mission.rules.protect.push_back(id);
    team.mission.rules.opened = {{id, after_all}};
    const Plan late = Planner().plan(team.map, team.mission);
    const Plan none = Planner().plan(standing.map, standing.mission);
    if (none.status == PlanStatus::solved && late.status == PlanStatus::solved) {
        RC_TAG(reached(team.mission, late) <= reached(team.mission, none) * (1 + 1e-9) ? "as good" : "worse");
        RC_ASSERT(reached(team.mission, late) < after_all);
    }
    if (none.gap == 0.0) RC_ASSERT(reached(team.mission, late) >= reached(team.mission, none) * (1 - 1e-9));
    team.mission.rules.opened[0].at = *rc::gen::element(0.5, 3.0, 10.0);
    const Plan early = Planner().plan(team.map, team.mission);
    RC_ASSERT(plan_faults(team.map, team.mission, early) == "");
    if (early.gap != 0.0) return;
    team.mission.rules.opened[0].at += 2;
    RC_ASSERT(reached(team.mission, Planner().plan(team.map, team.mission)) >=
              reached(team.mission, early) * (1 - 1e-9));
}

// One comes down the only street until it is ready; the other has to let it pass.
TEST(TeamsUnderWay, OthersKeepClearOfAnApproach) {
    constexpr auto picture = "........\n###.####";
    const Map map = map_from_ascii(picture);
    Mission mission{{vehicle("a", {4, 0}, {7, 0}), vehicle("b", {0, 0}, {3, 1})}};
    Agent& comes = mission.agents[0];
    comes.ready_at = 6;
    comes.approach = {{0.5, 0, 2.5}, {4, 0, 6}};
    const Plan plan = Planner().plan(map, mission);
    ASSERT_EQ(plan.status, PlanStatus::solved);
    EXPECT_TRUE(is_valid(map, mission, plan));
    EXPECT_EQ(simulate(map, mission, plan, 0.01), "");
    EXPECT_EQ(plan.agents[0].path[0], (Waypoint{0.5, 0, 2.5}));
    EXPECT_EQ(plan.agents[0].path[1], (Waypoint{4, 0, 6}));
    EXPECT_NEAR(plan.agents[0].path.back().t, 9, 1e-9);
    EXPECT_NEAR(plan.agents[1].path.back().t, 4, 1e-9);  // it is in the niche before the other comes by
}

// Before its approach it is not there at all: others may pass where it will begin.
TEST(TeamsUnderWay, NobodyIsThereBeforeItsApproach) {
    const Map map = map_from_ascii("......");
    Mission mission{{vehicle("a", {3, 0}, {3, 0}), vehicle("b", {0, 0}, {5, 0})}};
    Agent& comes = mission.agents[0];
    comes.ready_at = 20;
    comes.approach = {{3, 0, 20}};
    const Plan plan = Planner().plan(map, mission);
    ASSERT_EQ(plan.status, PlanStatus::solved);
    EXPECT_TRUE(is_valid(map, mission, plan));
    EXPECT_NEAR(plan.agents[1].path.back().t, 5, 1e-9);
    EXPECT_EQ(plan.agents[0].path, (std::vector<Waypoint>{{3, 0, 20}}));
}

}  // namespace
}  // namespace waybreaker
