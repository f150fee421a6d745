// Numbers that are none, in every place of a plan and of a mission, and sums that overflow.
#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <optional>
#include <set>
#include <vector>

#include "ascii_map.hpp"
#include "checked_plan.hpp"
#include "hand_made.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

struct Made {
    Mission mission;
    Plan plan;
};

// The aircraft takes its time to open a, so that a vehicle waits.
const Map& two_walls() {
    static const Map map = map_from_ascii(R"(
        ...a....b...
        ...a....b...
        ...a....b...
        ...a........)");
    return map;
}

// One vehicle and one aircraft, or a team of two; everything that can be explained is.
Made explained(bool team) {
    Made made{ground_and_air({0, 0}, {11, 0}), {}};
    made.mission.rules.removals = 1;
    made.mission.rules.breach_time.per_obstacle = 3;
    if (team) {
        Agent second = made.mission.agents[0];
        second.id = "second";
        second.start.y = second.goal.y = 2;
        made.mission.agents.insert(made.mission.agents.begin(), second);
    }
    made.plan = Planner().plan(two_walls(), made.mission, {.explain = true});
    made.plan.next = {{.obstacle = two_walls().obstacle_at({8, 0}), .saves = 1}};
    return made;
}

void for_each_optional(std::optional<double>& number, const std::function<void(double&)>& visit) {
    if (number) visit(*number);
}

// All but `saves` and what is only measured.
void for_each_number(Plan& plan, const std::function<void(double&)>& visit) {
    for (Outcome* outcome : {&plan.before, &plan.after}) {
        for (auto* figure : {&outcome->makespan, &outcome->flowtime, &outcome->ground_makespan}) {
            for_each_optional(*figure, visit);
        }
        for (Route& route : outcome->routes) {
            for_each_optional(route.length, visit);
            for (Point& point : route.path) visit(point.x), visit(point.y);
        }
    }
    for_each_optional(plan.bound, visit);
    for_each_optional(plan.gap, visit);
    for (Breach& breach : plan.breaches) {
        visit(breach.cleared_at);
        for_each_optional(breach.entered_at, visit);
        for_each_optional(breach.begun_at, visit);
    }
    for (NextBreach& next : plan.next) visit(next.saves);
    for (Itinerary& agent : plan.agents) {
        visit(agent.speed);
        for_each_optional(agent.gain, visit);
        for (Waypoint& at : agent.path) visit(at.x), visit(at.y), visit(at.t);
        for (Wait& wait : agent.waits) visit(wait.at.x), visit(wait.at.y), visit(wait.from), visit(wait.until);
    }
}

TEST(CheckedNumbers, OfAPlanAreFinite) {
    for (const bool team : {false, true}) {
        Made made = explained(team);
        ASSERT_TRUE(is_valid(two_walls(), made.mission, made.plan));
        const auto waits = [](const Itinerary& agent) { return !agent.waits.empty(); };
        ASSERT_TRUE(std::ranges::any_of(made.plan.agents, waits));
        int index = 0;
        for_each_number(made.plan, [&](double& number) {
            const double valid = number;
            for (const double none : {nan, infinity, -infinity}) {
                number = none;
                EXPECT_FALSE(check(two_walls(), made.mission, made.plan).empty()) << "number " << index << ": " << none;
            }
            number = valid;
            ++index;
        });
        EXPECT_GT(index, 50);
        ASSERT_TRUE(is_valid(two_walls(), made.mission, made.plan));
    }
}

// Without an obstacle there may be no plan at all.
TEST(CheckedNumbers, WhatARemovalSavesMayBeInfinite) {
    Made made = explained(false);
    std::optional<double>& saves = made.plan.breaches[0].saves;
    saves = infinity;
    EXPECT_TRUE(is_valid(two_walls(), made.mission, made.plan));
    for (const double none : {nan, -infinity}) {
        saves = none;
        EXPECT_EQ(broken_rules(two_walls(), made.mission, made.plan), std::set<Rule>{Rule::saves});
    }
    saves.reset();
    IfFailed& plan_b = made.plan.breaches[0].if_failed.emplace(IfFailed{infinity});
    EXPECT_TRUE(is_valid(two_walls(), made.mission, made.plan));
    for (const double none : {nan, -infinity}) {
        plan_b.objective = none;
        EXPECT_TRUE(broken_rules(two_walls(), made.mission, made.plan).contains(Rule::if_failed));
    }
}

TEST(CheckedNumbers, OfAMissionAreInRange) {
    const Made made = explained(true);
    const std::vector<std::function<void(Mission&, double)>> members{
        [](Mission& mission, double value) { mission.agents[0].ready_at = value; },
        [](Mission& mission, double value) { mission.agents[0].body.radius = value; },
        [](Mission& mission, double value) { mission.rules.budget = value; },
        [](Mission& mission, double value) { mission.rules.separation = value; },
        [](Mission& mission, double value) { mission.rules.breach_time.per_obstacle = value; },
        [](Mission& mission, double value) { mission.rules.breach_time.per_cell = value; },
    };
    for (const auto& set : members) {
        for (const double none : {nan, -infinity, -1.0}) {
            Mission mission = made.mission;
            set(mission, none);
            EXPECT_THROW(static_cast<void>(check(two_walls(), mission, made.plan)), InputError);
        }
    }
    for (const double none : {nan, infinity, -1.0}) {
        EXPECT_THROW(static_cast<void>(check(two_walls(), made.mission, made.plan, none)), InputError);
    }
}

// The way there and back is too long for a double, and takes no time.
TEST(CheckedNumbers, NobodyFliesFartherThanCanBeAdded) {
    constexpr double far = 1.7e308;
    const Map map = map_from_ascii("........");
    Plan plan = hand_made(driven({{0, 0}, {7, 0}}), {{0, 0, 0}, {far, far, 1}, {7, 0, 2}});
    plan.after.air().length = 7;
    EXPECT_EQ(broken_rules(map, plan), (std::set<Rule>{Rule::speed, Rule::length}));
}

// No plan ends before it begins, and none is so many times as good as nothing.
TEST(CheckedNumbers, ABoundOfNothingHasNoGap) {
    const Map map = map_from_ascii("........");
    const auto rules = [&](std::optional<double> bound, std::optional<double> gap, double end) {
        const std::vector<Waypoint> path = driven({{0, 0}, {end, 0}});
        Plan plan = hand_made(path, path);
        plan.before = plan.after;
        plan.bound = bound;
        plan.gap = gap;
        return broken_rules(map, plan);
    };
    EXPECT_EQ(rules(7, 0, 7), std::set<Rule>{});
    EXPECT_EQ(rules(0, std::nullopt, 7), std::set<Rule>{});
    EXPECT_EQ(rules(0, 0, 0), std::set<Rule>{});
    EXPECT_EQ(rules(0, 0.1, 0), std::set<Rule>{Rule::gap});
    EXPECT_EQ(rules(0, 0, 7), std::set<Rule>{Rule::gap});
    EXPECT_EQ(rules(-1, std::nullopt, 7), std::set<Rule>{Rule::bound});
    EXPECT_EQ(rules(-1, 0, 7), (std::set<Rule>{Rule::bound, Rule::gap}));
    EXPECT_EQ(rules(-1, -8, 7), (std::set<Rule>{Rule::bound, Rule::gap}));
}

}  // namespace
}  // namespace waybreaker
