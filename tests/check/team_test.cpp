// Plans of teams with one thing wrong: each is rejected, for the right reason.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <functional>
#include <map>

#include "ascii_map.hpp"
#include "checked_plan.hpp"
#include "random_map.hpp"
#include "vehicle.hpp"

namespace waybreaker {
namespace {

struct TeamPlan {
    Mission mission;
    Plan plan;
};

// Figures and lengths that follow from the paths.
void set_figures(TeamPlan& made) {
    double makespan = 0;
    double flowtime = 0;
    for (std::size_t i = 0; i < made.plan.agents.size(); ++i) {
        double length = 0;
        const std::vector<Waypoint>& path = made.plan.agents[i].path;
        for (std::size_t k = 1; k < path.size(); ++k) {
            length += std::hypot(path[k].x - path[k - 1].x, path[k].y - path[k - 1].y);
        }
        made.plan.after.routes[i].length = length;
        makespan = std::max(makespan, path.back().t);
        flowtime += path.back().t;
    }
    made.plan.after.makespan = makespan;
    made.plan.after.ground_makespan = makespan;
    made.plan.after.flowtime = flowtime;
    made.plan.gap = made.mission.rules.objective == Objective::flowtime ? flowtime / *made.plan.bound - 1
                                                                        : makespan / *made.plan.bound - 1;
}

const Map& yard() {
    static const Map map = map_from_ascii(R"(
        .........
        .........
        ####.####
        .........
        .........)");
    return map;
}

TeamPlan planned_team() {
    TeamPlan made;
    made.mission.rules.objective = Objective::flowtime;
    made.mission.agents = {vehicle("a", {0, 0}, {8, 4}), vehicle("b", {8, 0}, {0, 4}), vehicle("c", {4, 4}, {4, 0})};
    made.mission.agents[2].ready_at = 1;
    made.plan = Planner().plan(yard(), made.mission);
    return made;
}

std::set<Rule> broken(const TeamPlan& made) {
    std::set<Rule> rules;
    for (const Violation& violation : check(yard(), made.mission, made.plan)) rules.insert(violation.rule);
    return rules;
}

TEST(TeamCheck, AcceptsThePlan) {
    const TeamPlan made = planned_team();
    ASSERT_EQ(made.plan.status, PlanStatus::solved);
    EXPECT_TRUE(is_valid(yard(), made.mission, made.plan));
}

// One that has nowhere to go may not vanish before it is ready.
TEST(TeamCheck, RejectsAnAgentThatVanishesBeforeItIsReady) {
    TeamPlan made;
    made.mission.rules.at_goal = AtGoal::leave;
    made.mission.agents = {vehicle("a", {4, 4}, {4, 4}), vehicle("b", {0, 4}, {8, 4})};
    made.plan = Planner().plan(yard(), made.mission);
    ASSERT_EQ(made.plan.status, PlanStatus::solved);
    EXPECT_EQ(broken(made), std::set<Rule>{});
    made.mission.agents[0].ready_at = 3;
    EXPECT_TRUE(broken(made).contains(Rule::start));
}

TEST(TeamCheck, RejectsEachFault) {
    const std::map<std::string, std::pair<Rule, std::function<void(TeamPlan&)>>> faults{
        {"all drive as if alone",
         {Rule::separation,
          [](TeamPlan& made) {
              for (std::size_t i = 0; i < 3; ++i) {
                  std::vector<Waypoint>& path = made.plan.agents[i].path;
                  double time = made.mission.agents[i].ready_at;
                  path = {{made.plan.before.routes[i].path[0].x, made.plan.before.routes[i].path[0].y, 0}};
                  if (time > 0) path.push_back({path[0].x, path[0].y, time});
                  const std::vector<Point>& way = made.plan.before.routes[i].path;
                  for (std::size_t k = 1; k < way.size(); ++k) {
                      time += distance(way[k - 1], way[k]);
                      path.push_back({way[k].x, way[k].y, time});
                  }
              }
          }}},
        {"more room is asked for", {Rule::separation, [](TeamPlan& made) { made.mission.rules.separation = 3; }}},
        {"a wider body",
         {Rule::separation,
          [](TeamPlan& made) {
              for (Agent& agent : made.mission.agents) agent.body.radius = 1.5;
          }}},
        {"not ready yet", {Rule::start, [](TeamPlan& made) { made.mission.agents[2].ready_at = 500; }}},
        {"an agent is missing", {Rule::agents, [](TeamPlan& made) { made.plan.agents.pop_back(); }}},
        {"an agent is there twice", {Rule::agents, [](TeamPlan& made) { made.plan.agents[1] = made.plan.agents[0]; }}},
        {"an agent is another one", {Rule::agents, [](TeamPlan& made) { made.plan.agents[1].id = "x"; }}},
        {"a route is missing", {Rule::agents, [](TeamPlan& made) { made.plan.after.routes.pop_back(); }}},
        {"too fast", {Rule::speed, [](TeamPlan& made) { made.plan.agents[0].path.back().t -= 1; }}},
        {"back in time", {Rule::time, [](TeamPlan& made) { made.plan.agents[0].path.back().t = -1; }}},
        {"no goal", {Rule::goal, [](TeamPlan& made) { made.plan.agents[0].path.pop_back(); }}},
        {"through a wall",
         {Rule::collision,
          [](TeamPlan& made) {
              const double time = std::sqrt(8 * 8 + 4 * 4);
              made.plan.agents[0].path = {{0, 0, 0}, {8, 4, time}};
          }}},
        {"no centre",
         {Rule::vertex,
          [](TeamPlan& made) {
              made.plan.agents[0].path.insert(made.plan.agents[0].path.begin() + 1, {0.5, 0, 0.5});
          }}},
        {"no path", {Rule::agents, [](TeamPlan& made) { made.plan.agents[0].path.clear(); }}},
        {"something is removed", {Rule::removals, [](TeamPlan& made) { made.plan.breaches.emplace_back(); }}},
        {"makespan", {Rule::makespan, [](TeamPlan& made) { *made.plan.after.makespan += 1; }}},
        {"flowtime", {Rule::flowtime, [](TeamPlan& made) { *made.plan.after.flowtime -= 1; }}},
        {"ground makespan", {Rule::ground_makespan, [](TeamPlan& made) { made.plan.after.ground_makespan.reset(); }}},
        {"length", {Rule::length, [](TeamPlan& made) { *made.plan.after.routes[1].length += 1; }}},
        {"alone", {Rule::before, [](TeamPlan& made) { made.plan.before.routes[1].length = 1; }}},
        {"alone, all", {Rule::before, [](TeamPlan& made) { *made.plan.before.flowtime += 1; }}},
        {"bound", {Rule::bound, [](TeamPlan& made) { made.plan.bound = 1e6; }}},
        {"gap", {Rule::gap, [](TeamPlan& made) { made.plan.gap = 0.7; }}},
        {"status", {Rule::status, [](TeamPlan& made) { made.plan.status = PlanStatus::no_plan; }}},
    };
    for (const auto& [name, fault] : faults) {
        TeamPlan made = planned_team();
        fault.second(made);
        EXPECT_TRUE(broken(made).contains(fault.first)) << name;
    }
}

// Two that drive along rows beside each other, and one that stands.
TeamPlan hand_made(double row_apart) {
    TeamPlan made;
    made.mission.agents = {vehicle("a", {0, 0}, {8, 0}), vehicle("b", {0, 1}, {8, 1}), vehicle("c", {4, 4}, {4, 4})};
    made.mission.rules.separation = row_apart - 1;
    made.plan.status = PlanStatus::solved;
    made.plan.bound = 8;
    for (const Agent& agent : made.mission.agents) {
        const double length = distance(agent.start, agent.goal);
        std::vector<Waypoint> path{{double(agent.start.x), double(agent.start.y), 0}};
        if (length > 0) path.push_back({double(agent.goal.x), double(agent.goal.y), length});
        made.plan.agents.push_back({agent.id, agent.kind, 1, path, agent.start, agent.goal});
    }
    Route along;
    along.length = 8;
    Route still;
    still.length = 0;
    made.plan.before.routes = made.plan.after.routes = {along, along, still};
    made.plan.before.makespan = made.plan.before.ground_makespan = 8;
    made.plan.before.flowtime = 16;
    set_figures(made);
    return made;
}

TEST(TeamCheck, LetsDiscsTouch) {
    EXPECT_EQ(broken(hand_made(1)), std::set<Rule>{});
    EXPECT_EQ(broken(hand_made(1.00001)), std::set<Rule>{Rule::separation});
}

TEST(TeamCheck, LooksAtThoseWhoStandAtTheirGoals) {
    TeamPlan made = hand_made(1);
    // From below to above, over the goal of one that has arrived long ago.
    made.mission.agents[2] = vehicle("c", {8, 3}, {8, 0});
    made.plan.agents[2].start = {8, 3};
    made.plan.agents[2].goal = {8, 0};
    made.mission.agents[0].goal = made.plan.agents[0].goal = {2, 0};
    made.plan.agents[0].path = {{0, 0, 0}, {2, 0, 2}};
    made.plan.agents[2].path = {{8, 3, 0}, {8, 3, 20}, {8, 0, 23}};
    EXPECT_TRUE(broken(made).contains(Rule::separation));  // b stands at 8,1
    made.mission.rules.at_goal = AtGoal::leave;
    EXPECT_FALSE(broken(made).contains(Rule::separation));
}

}  // namespace
}  // namespace waybreaker
