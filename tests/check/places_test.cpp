// Plans with many places, with one thing wrong: each is rejected, for the right reason.
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

struct Made {
    Mission mission;
    Plan plan;
};

// Nobody can get to the place on the right: everything around it stays.
const Map& street() {
    static const Map map = map_from_ascii(R"(
        ....#.
        ....#.
        ....#.)");
    return map;
}

Made made_plan() {
    Made made;
    made.mission.rules = {.removals = 0, .objective = Objective::flowtime, .collisions = false, .unreached = 20};
    made.mission.agents = {vehicle("near", {0, 0}, {3, 0}), vehicle("same", {0, 0}, {3, 0}),
                           vehicle("far", {0, 0}, {5, 2})};
    made.mission.agents[0].weight = 2.5;
    made.mission.agents[2].weight = 4;
    made.plan = Planner().plan(street(), made.mission);
    return made;
}

std::set<Rule> broken(const Made& made) {
    std::set<Rule> rules;
    for (const Violation& violation : check(street(), made.mission, made.plan)) rules.insert(violation.rule);
    return rules;
}

TEST(PlacesCheck, AcceptsThePlan) {
    const Made made = made_plan();
    ASSERT_EQ(made.plan.status, PlanStatus::solved);
    EXPECT_TRUE(is_valid(street(), made.mission, made.plan));
    EXPECT_DOUBLE_EQ(*made.plan.after.flowtime, 2.5 * 3 + 3 + 4 * 20);
}

TEST(PlacesCheck, RejectsEachFault) {
    const std::vector<std::pair<Rule, std::function<void(Made&)>>> faults{
        {Rule::separation, [](Made& made) { made.mission.rules.collisions = true; }},
        {Rule::flowtime, [](Made& made) { made.mission.agents[0].weight = 2; }},
        {Rule::flowtime, [](Made& made) { made.mission.agents[2].weight = 1; }},
        {Rule::goal, [](Made& made) { made.mission.rules.unreached.reset(); }},
        {Rule::goal, [](Made& made) { made.mission.rules.unreached = 21; }},
        {Rule::goal, [](Made& made) { made.mission.rules.unreached = 2; }},
        {Rule::goal, [](Made& made) { made.plan.agents[2].reached = true; }},
        {Rule::goal, [](Made& made) { made.plan.agents[0].reached = false; }},
        {Rule::goal, [](Made& made) { made.plan.agents[2].path.back().t = 12; }},
        {Rule::length, [](Made& made) { made.plan.after.routes[2].length = 0; }},
        {Rule::before, [](Made& made) { *made.plan.before.flowtime += 1; }},
    };
    for (std::size_t i = 0; i < faults.size(); ++i) {
        Made made = made_plan();
        faults[i].second(made);
        EXPECT_TRUE(broken(made).contains(faults[i].first)) << i;
    }
}

}  // namespace
}  // namespace waybreaker
