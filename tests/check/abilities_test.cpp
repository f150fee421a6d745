// Breaches that an agent is not able to, or that take another time than its own: rejected, for the right reason.
#include <gtest/gtest.h>

#include <functional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "ascii_map.hpp"
#include "checked_plan.hpp"

namespace waybreaker {
namespace {

struct Able {
    Mission mission;
    Plan plan;
};

const Map& three_cells() {
    static const Map map = map_from_ascii(R"(
        ......#......
        ......#......
        ......#......)");
    return map;
}

// The one that breaches needs six units of time for the three cells, in place of the rules' hundred.
Able able_plan(const Agent& breacher, std::vector<Agent> others) {
    Able made;
    made.mission.agents = std::move(others);
    made.mission.agents.push_back(breacher);
    made.mission.rules.breach_time.per_obstacle = 100;
    Agent& agent = made.mission.agents.back();
    agent.breach_time = 3;
    agent.breach_time_per_cell = 1;
    agent.can_breach = CanBreach{.most_cells = 3, .only = std::vector<ObstacleId>{{1}}};
    made.plan = Planner().plan(three_cells(), made.mission);
    return made;
}

std::set<Rule> broken_by(const Able& made) {
    std::set<Rule> rules;
    for (const Violation& violation : check(three_cells(), made.mission, made.plan)) rules.insert(violation.rule);
    return rules;
}

void reject_each_fault(const std::function<Able()>& plan, const std::vector<Rule>& of_times) {
    const Able planned = plan();
    ASSERT_EQ(planned.plan.breaches.size(), 1U);
    ASSERT_EQ(broken_by(planned), std::set<Rule>());
    const std::vector<std::pair<Rule, std::function<void(Agent&)>>> faults{
        {Rule::obstacle, [](Agent& agent) { agent.can_breach->most_cells = 2; }},
        {Rule::obstacle, [](Agent& agent) { agent.can_breach->only = {{{2}}}; }},
        {Rule::obstacle, [](Agent& agent) { agent.can_breach->only->clear(); }},
    };
    for (std::size_t i = 0; i < faults.size(); ++i) {
        Able made = plan();
        faults[i].second(made.mission.agents.back());
        EXPECT_TRUE(broken_by(made).contains(faults[i].first)) << i;
    }
    for (const Rule rule : of_times) {
        Able made = plan();
        made.mission.agents.back().breach_time = 4;
        EXPECT_TRUE(broken_by(made).contains(rule));
        made.mission.agents.back().breach_time = 3;
        made.mission.agents.back().breach_time_per_cell.reset();
        made.mission.rules.breach_time.per_cell = 2;
        EXPECT_TRUE(broken_by(made).contains(rule));
    }
}

TEST(AbilitiesCheck, RejectsEachFaultOfOneAircraft) {
    const auto plan = [] { return able_plan(aircraft("air", {0, 1}), {vehicle("rover", {0, 1}, {12, 1})}); };
    reject_each_fault(plan, {Rule::breach});
}

TEST(AbilitiesCheck, RejectsEachFaultOfATeam) {
    const auto plan = [] {
        return able_plan(aircraft("air", {0, 1}),
                         {vehicle("rover", {0, 1}, {12, 1}), vehicle("other", {0, 2}, {0, 0})});
    };
    reject_each_fault(plan, {Rule::breach});
}

TEST(AbilitiesCheck, RejectsEachFaultOfAVehicleAlone) {
    Agent dozer = vehicle("dozer", {0, 1}, {12, 1});
    dozer.own_breaches = 1;
    reject_each_fault([&] { return able_plan(dozer, {}); }, {Rule::breach});
}

TEST(AbilitiesCheck, RejectsEachFaultOfAVehicleThatClears) {
    Agent dozer = vehicle("dozer", {0, 0}, {0, 2});
    dozer.own_breaches = 1;
    dozer.reach = 2.5;
    const auto plan = [&] { return able_plan(dozer, {vehicle("rover", {0, 1}, {12, 1})}); };
    reject_each_fault(plan, {Rule::breach});
    Able made = plan();
    EXPECT_EQ(made.plan.breaches.front().at, (Cell{3, 0}));
    made.mission.agents.back().reach = 1.9;
    EXPECT_TRUE(broken_by(made).contains(Rule::boundary));
}

}  // namespace
}  // namespace waybreaker
