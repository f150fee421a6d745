// Plans with aircraft that breach for a team, and one thing wrong with each: rejected, for the right reason.
#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <set>

#include "ascii_map.hpp"
#include "checked_plan.hpp"

namespace waybreaker {
namespace {

struct CoalitionPlan {
    Mission mission;
    Plan plan;
    Breach& first() { return plan.breaches[0]; }
    Breach& second() { return plan.breaches[1]; }
    std::vector<Waypoint>& path(std::size_t agent) { return plan.agents[agent].path; }
};

const Map& walls() {
    static const Map map = map_from_ascii(R"(
        ...a...b...
        ...a...b...
        ...a...b...
        ...a...b...)");
    return map;
}

Agent agent(const std::string& id, AgentKind kind, Cell start, Cell goal) {
    Agent agent;
    agent.id = id;
    agent.kind = kind;
    agent.start = start;
    agent.goal = goal;
    return agent;
}

// Vehicles 0 and 1, aircraft 2 (west) and 3 (east), a wall for each of these.
CoalitionPlan planned_coalition() {
    CoalitionPlan made;
    made.mission.rules.removals = 2;
    made.mission.rules.breach_time.per_obstacle = 3;
    made.mission.rules.objective = Objective::flowtime;
    made.mission.agents = {
        agent("up", AgentKind::ground, {0, 0}, {10, 0}), agent("down", AgentKind::ground, {0, 3}, {10, 3}),
        agent("west", AgentKind::air, {0, 2}, {0, 2}), agent("east", AgentKind::air, {10, 2}, {10, 2})};
    made.plan = Planner().plan(walls(), made.mission);
    return made;
}

std::set<Rule> broken(const CoalitionPlan& made) {
    std::set<Rule> rules;
    for (const Violation& violation : check(walls(), made.mission, made.plan)) rules.insert(violation.rule);
    return rules;
}

TEST(CoalitionCheck, AcceptsThePlan) {
    const CoalitionPlan made = planned_coalition();
    ASSERT_EQ(made.plan.breaches.size(), 2U);
    ASSERT_NE(made.plan.breaches[0].by, made.plan.breaches[1].by);
    EXPECT_TRUE(is_valid(walls(), made.mission, made.plan));
}

TEST(CoalitionCheck, RejectsEachFault) {
    const std::map<std::string, std::pair<Rule, std::function<void(CoalitionPlan&)>>> faults{
        {"by nobody", {Rule::breach, [](CoalitionPlan& made) { made.first().by.clear(); }}},
        {"by a vehicle", {Rule::breach, [](CoalitionPlan& made) { made.first().by = "up"; }}},
        {"by the other aircraft, which is elsewhere",
         {Rule::breach, [](CoalitionPlan& made) { made.first().by = made.second().by; }}},
        {"more than an aircraft may",
         {Rule::capacity,
          [](CoalitionPlan& made) { made.mission.agents[made.first().by == "west" ? 2 : 3].breaches = 0; }}},
        {"fewer than none",
         {Rule::capacity,
          [](CoalitionPlan& made) { made.mission.agents[made.first().by == "west" ? 2 : 3].breaches = -5; }}},
        {"begins too late", {Rule::breach, [](CoalitionPlan& made) { *made.first().begun_at += 1; }}},
        {"begins some time", {Rule::breach, [](CoalitionPlan& made) { made.first().begun_at.reset(); }}},
        {"breaches take longer",
         {Rule::breach, [](CoalitionPlan& made) { made.mission.rules.breach_time.per_obstacle = 4; }}},
        {"too many", {Rule::removals, [](CoalitionPlan& made) { made.mission.rules.removals = 1; }}},
        {"too heavy", {Rule::budget, [](CoalitionPlan& made) { made.mission.rules.budget = 1; }}},
        {"one is protected", {Rule::obstacle, [](CoalitionPlan& made) { made.mission.rules.protect = {{1}}; }}},
        {"one is removed twice", {Rule::repetition, [](CoalitionPlan& made) { made.second() = made.first(); }}},
        {"one has to go and stays",
         {Rule::removals,
          [](CoalitionPlan& made) {
              made.mission.rules.force = {made.second().obstacle};
              made.plan.breaches.pop_back();
          }}},
        {"one still stands", {Rule::collision, [](CoalitionPlan& made) { made.plan.breaches.pop_back(); }}},
        {"not from the boundary",
         {Rule::boundary,
          [](CoalitionPlan& made) {
              made.first().at = {5, 2};
          }}},
        {"cleared later than vehicles come",
         {Rule::collision,
          [](CoalitionPlan& made) {
              for (Breach& breach : made.plan.breaches) {
                  breach.cleared_at += 50;
                  *breach.begun_at += 50;
              }
          }}},
        {"in another order",
         {Rule::order,
          [](CoalitionPlan& made) {
              made.second().cleared_at += 1;
              std::swap(made.first(), made.second());
          }}},
        {"entered by nobody", {Rule::entered, [](CoalitionPlan& made) { made.first().entered_at.reset(); }}},
        {"entered later", {Rule::entered, [](CoalitionPlan& made) { *made.first().entered_at += 1; }}},
        {"an aircraft does not wait",
         {Rule::breach,
          [](CoalitionPlan& made) {
              std::vector<Waypoint>& path = made.path(made.first().by == "west" ? 2 : 3);
              path.erase(path.begin() + 2);
              path.back().t -= 3;
          }}},
        {"figures for all without removals",
         {Rule::before, [](CoalitionPlan& made) { made.plan.before.flowtime = 100; }}},
    };
    for (const auto& [name, fault] : faults) {
        CoalitionPlan made = planned_coalition();
        fault.second(made);
        EXPECT_TRUE(broken(made).contains(fault.first)) << name;
    }
}

TEST(CoalitionCheck, NamesEveryRule) {
    for (int rule = 0; rule <= int(Rule::capacity); ++rule) EXPECT_NE(to_string(Rule(rule)), "") << rule;
}

}  // namespace
}  // namespace waybreaker
