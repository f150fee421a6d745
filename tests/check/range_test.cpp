// Plans of aircraft with a range, with one thing wrong: each is rejected, for the right reason.
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

struct Ranged {
    Mission mission;
    Plan plan;
};

const Map& wall() {
    static const Map map = map_from_ascii(R"(
        ......#...
        ......#...
        ......#...)");
    return map;
}

// Five cells there, two units of time at the wall, five back: at speed 1 a flight of 12.
Ranged ranged_plan() {
    Ranged made;
    made.mission.agents = {vehicle("rover", {0, 1}, {9, 1}), aircraft("air", {0, 1})};
    made.mission.rules.breach_time.per_obstacle = 2;
    made.mission.agents[1].ready_at = 4;
    made.mission.agents[1].range = 12;
    made.mission.agents[1].endurance = 12;
    made.plan = Planner().plan(wall(), made.mission);
    return made;
}

std::set<Rule> broken_in(const Ranged& made) {
    std::set<Rule> rules;
    for (const Violation& violation : check(wall(), made.mission, made.plan)) rules.insert(violation.rule);
    return rules;
}

TEST(RangeCheck, AcceptsThePlan) {
    const Ranged made = ranged_plan();
    ASSERT_EQ(made.plan.status, PlanStatus::solved);
    ASSERT_EQ(made.plan.breaches.size(), 1U);
    EXPECT_TRUE(is_valid(wall(), made.mission, made.plan));
}

TEST(RangeCheck, RejectsEachFault) {
    const auto far = [](Ranged& made) -> OutOfRange& {
        return made.plan.out_of_range.emplace_back(OutOfRange{ObstacleId{1}, 0, "air", 13, 12});
    };
    const std::vector<std::pair<Rule, std::function<void(Ranged&)>>> faults{
        {Rule::range, [](Ranged& made) { made.mission.agents[1].range = 11.99; }},
        {Rule::endurance, [](Ranged& made) { made.mission.agents[1].endurance = 11.99; }},
        {Rule::range, [](Ranged& made) { made.mission.agents[1].reserve = 0.01; }},
        {Rule::endurance, [](Ranged& made) { made.mission.agents[1].reserve = 0.01; }},
        {Rule::range, [](Ranged& made) { made.plan.agents[1].path.back().x = 20; }},
        {Rule::endurance, [](Ranged& made) { made.plan.agents[1].path.back().t += 1; }},
        {Rule::range, [&](Ranged& made) { far(made).obstacle = ObstacleId{7}; }},
        {Rule::range, [&](Ranged& made) { far(made).agent = "rover"; }},
        {Rule::range, [&](Ranged& made) { far(made).longest = 14; }},
        {Rule::range, [&](Ranged& made) { far(made).flight = 11; }},
        {Rule::range, [&](Ranged& made) { far(made).flight = 2; }},
    };
    for (std::size_t i = 0; i < faults.size(); ++i) {
        Ranged made = ranged_plan();
        faults[i].second(made);
        EXPECT_TRUE(broken_in(made).contains(faults[i].first)) << i;
    }
}

// To wait on the ground costs nothing, before the flight and after it.
TEST(RangeCheck, LetsAircraftWaitOnTheGround) {
    Ranged made = ranged_plan();
    std::vector<Waypoint>& path = made.plan.agents[1].path;
    for (std::size_t i = 1; i < path.size(); ++i) path[i].t += 100;
    for (Breach& breach : made.plan.breaches) breach.cleared_at += 100;
    path.push_back(path.back());
    path.back().t += 100;
    const std::set<Rule> rules = broken_in(made);
    EXPECT_FALSE(rules.contains(Rule::range));
    EXPECT_FALSE(rules.contains(Rule::endurance));
}

}  // namespace
}  // namespace waybreaker
