#include "server/plan_request.hpp"

#include <gtest/gtest.h>

#include "input_error.hpp"

namespace waybreaker::server {
namespace {

io::MapFile three_cells() {
    return io::parse_map("type octile\nheight 1\nwidth 5\nmap\n.@.@@\n", "m.map");
}

std::string refusal(const std::string& text) {
    return input_error([&] { parse_plan_request(text); });
}

TEST(PlanRequest, WhatIsLeftOutHasTheDefaultsOfTheCommand) {
    const PlanRequest request = parse_plan_request("{}");
    const MissionOptions options = options_of(request.options, three_cells());
    EXPECT_EQ(options.removals, MissionOptions().removals);
    EXPECT_EQ(options.search.planner, Planner::optimal);
    EXPECT_TRUE(options.weights.empty());
    EXPECT_TRUE(request.timing_fields);
}

TEST(PlanRequest, AgentsGoWhereTheyAreToldTo) {
    const PlanRequest request = parse_plan_request(
        R"({"mission": {"start": [0, 0], "goal": [2, 0], "air_goal": [4, 0], "air_speed": 2, "ground_speed": 0.5}})");
    const Mission mission = mission_of(request.mission, three_cells());
    ASSERT_EQ(mission.agents.size(), 2U);
    for (const Agent& agent : mission.agents) {
        const bool flies = agent.kind == AgentKind::air;
        EXPECT_EQ(agent.start, (Cell{0, 0}));
        EXPECT_EQ(agent.goal, flies ? (Cell{4, 0}) : (Cell{2, 0}));
        EXPECT_EQ(agent.speed, flies ? 2 : 0.5);
    }
}

TEST(PlanRequest, ThePaperIsItsMethodUnlessOneSaysOtherwise) {
    const PlanRequest request =
        parse_plan_request(R"({"options": {"paper": true, "removals": 2, "timing": "enforce"}})");
    const MissionOptions options = options_of(request.options, three_cells());
    EXPECT_EQ(options.select, Selection::hits);
    EXPECT_EQ(options.flight, FlightRule::nearest);
    EXPECT_EQ(options.search.planner, Planner::theta);
    EXPECT_EQ(options.timing, Timing::enforce);
}

TEST(PlanRequest, WeightsAndBudget) {
    const auto weights = [](const std::string& options) {
        return options_of(parse_plan_request(R"({"options": )" + options + "}").options, three_cells());
    };
    EXPECT_EQ(weights(R"({"weights": [[2, 0.5]]})").weights, (std::vector<double>{0, 1, 0.5}));
    const MissionOptions by_cells = weights(R"({"weights": "cells", "budget": 2})");
    EXPECT_EQ(by_cells.weights[1], 1);
    EXPECT_EQ(by_cells.weights[2], 2);
    EXPECT_EQ(by_cells.removals, 2);  // a budget alone stands in place of a count
    EXPECT_EQ(weights(R"({"budget": 2, "removals": 1})").removals, 1);
    EXPECT_NE(input_error([&] { weights(R"({"weights": [[3, 1]]})"); }), "");
}

TEST(PlanRequest, MethodsStartFromTheOptions) {
    const PlanRequest request = parse_plan_request(
        R"({"options": {"removals": 1, "protect": [2]}, "methods": [{"name": "a", "options": {"select": "hits"}},
                                                                    {"name": "b", "options": {"removals": 0}}]})");
    ASSERT_EQ(request.methods.size(), 2U);
    EXPECT_EQ(request.methods[0].options.options.removals, 1);
    EXPECT_EQ(request.methods[0].options.options.select, Selection::hits);
    EXPECT_EQ(request.methods[1].options.options.removals, 0);
    EXPECT_EQ(request.methods[1].options.options.protect, (std::vector<ObstacleId>{{2}}));
}

TEST(PlanRequest, SaysWhatIsWrongAndWhere) {
    EXPECT_EQ(refusal("{\"mission\": {\n \"start\": [1]}}"), "request:2:11: mission.start is not a cell, [x, y]");
    EXPECT_EQ(refusal(R"({"mission": {"air_speed": 0}})"), "request:1:27: mission.air_speed is not above 0");
    EXPECT_EQ(refusal(R"({"options": {"select": "best"}})"), "request:1:24: options.select is none of exact, hits");
    EXPECT_EQ(refusal(R"({"options": {"moves": 6}})"), "request:1:23: options.moves is neither 4 nor 8");
    EXPECT_EQ(refusal(R"({"options": {"removals": 33}})"), "request:1:26: options.removals is not between 0 and 32");
    EXPECT_EQ(refusal(R"({"plan": 1})"),
              "request:1:2: the document has a member that is none of mission, options, methods, no_timing");
    EXPECT_EQ(refusal("{\n!"), "request:2:1: this is not JSON");
}

}  // namespace
}  // namespace waybreaker::server
