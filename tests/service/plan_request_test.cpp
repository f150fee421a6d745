#include "request/plan_request.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "input_error.hpp"
#include "mapfile/map_reader.hpp"

namespace waybreaker::request {
namespace {

io::MapFile three_cells() {
    return mapfile::parse_map("type octile\nheight 1\nwidth 5\nmap\n.@.@@\n", "m.map");
}

std::string refusal(const std::string& text) {
    return input_error([&] { parse_plan_request(text); });
}

TEST(PlanRequest, WhatIsLeftOutHasTheDefaultsOfTheCommand) {
    const PlanRequest request = parse_plan_request("{}");
    EXPECT_EQ(request.options.asked.mission.rules.removals, Rules().removals);
    EXPECT_EQ(request.options.asked.method.planner, Algorithm::optimal);
    EXPECT_TRUE(request.timing_fields);
}

TEST(PlanRequest, AgentsHaveTheirStartsAndGoals) {
    const PlanRequest request = parse_plan_request(
        R"({"mission": {"start": [0, 0], "goal": [2, 0], "air_goal": [4, 0], "air_speed": 2, "ground_speed": 0.5}})");
    const Mission mission = on_map(request.mission, request.options, three_cells()).asked.mission;
    ASSERT_EQ(mission.agents.size(), 2U);
    for (const Agent& agent : mission.agents) {
        const bool flies = agent.kind == AgentKind::air;
        EXPECT_EQ(agent.start, (Cell{0, 0}));
        EXPECT_EQ(agent.goal, flies ? (Cell{4, 0}) : (Cell{2, 0}));
        EXPECT_EQ(agent.speed, flies ? 2 : 0.5);
    }
}

TEST(PlanRequest, AMissionInShortMayBeInSecondsToo) {
    const auto in_seconds = [](const std::string& mission) {
        const PlanRequest request = parse_plan_request(R"({"mission": )" + mission + "}");
        return on_map(request.mission, request.options, three_cells()).asked.in_seconds;
    };
    EXPECT_TRUE(in_seconds(R"({"start": [0, 0], "goal": [2, 0], "time_unit": "s"})"));
    EXPECT_FALSE(in_seconds(R"({"start": [0, 0], "goal": [2, 0]})"));
}

TEST(PlanRequest, ThePaperIsItsMethodUnlessOneSaysOtherwise) {
    const PlanRequest request =
        parse_plan_request(R"({"options": {"paper": true, "removals": 2, "timing": "enforce"}})");
    const Method& method = request.options.asked.method;
    EXPECT_EQ(method.select, Selection::hits);
    EXPECT_EQ(method.flight, FlightRule::nearest);
    EXPECT_EQ(method.planner, Algorithm::theta);
    EXPECT_EQ(request.options.asked.mission.rules.timing, Timing::enforce);
}

TEST(PlanRequest, WeightsAndBudget) {
    const auto weights = [](const std::string& options) {
        const PlanRequest request = parse_plan_request(
            fmt::format(R"({{"mission": {{"start": [0, 0], "goal": [2, 0]}}, "options": {}}})", options));
        const Map map = on_map(request.mission, request.options, three_cells()).reweighted.value();
        return std::vector{map.obstacle({1}).weight, map.obstacle({2}).weight};
    };
    const auto rules = [](const std::string& options) {
        const PlanRequest request = parse_plan_request(
            fmt::format(R"({{"mission": {{"start": [0, 0], "goal": [2, 0]}}, "options": {}}})", options));
        return on_map(request.mission, request.options, three_cells()).asked.mission.rules;
    };
    EXPECT_EQ(weights(R"({"weights": [[2, 0.5]]})"), (std::vector<double>{1, 0.5}));
    EXPECT_EQ(weights(R"({"weights": "cells", "budget": 2})"), (std::vector<double>{1, 2}));
    EXPECT_EQ(rules(R"({"weights": "cells", "budget": 2})").removals, 2) << "a budget alone stands in place of a count";
    EXPECT_EQ(rules(R"({"budget": 2, "removals": 1})").removals, 1);
    EXPECT_NE(input_error([&] { weights(R"({"weights": [[3, 1]]})"); }), "");
    EXPECT_NE(input_error([&] { weights(R"({"budget_m2": 2})"); }), "") << "the map has no metres";
    EXPECT_NE(input_error([&] { weights(R"({"budget_m2": 2, "weights": "cells"})"); }), "");
    io::MapFile in_metres = three_cells();
    in_metres.cell_size = 2;
    const PlanRequest area =
        parse_plan_request(R"({"mission": {"start": [0, 0], "goal": [2, 0]}, "options": {"budget_m2": 2}})");
    const MissionOnMap made = on_map(area.mission, area.options, in_metres);
    EXPECT_EQ(made.asked.mission.rules.removals, 2);
    EXPECT_EQ(made.reweighted.value().obstacle({2}).weight, 8) << "square metres";
}

TEST(PlanRequest, MethodsStartFromTheOptions) {
    const PlanRequest request = parse_plan_request(
        R"({"options": {"removals": 1, "protect": [2]}, "methods": [{"name": "a", "options": {"select": "hits"}},
                                                                    {"name": "b", "options": {"removals": 0}}]})");
    ASSERT_EQ(request.variants.size(), 2U);
    EXPECT_EQ(request.variants[0].options.asked.mission.rules.removals, 1);
    EXPECT_EQ(request.variants[0].options.asked.method.select, Selection::hits);
    EXPECT_EQ(request.variants[1].options.asked.mission.rules.removals, 0);
    EXPECT_EQ(request.variants[1].options.asked.mission.rules.protect, (std::vector<ObstacleId>{{2}}));
}

TEST(PlanRequest, SaysWhatIsWrongAndWhere) {
    EXPECT_EQ(refusal("{\"mission\": {\n \"start\": [1]}}"), "request:2:11: mission.start is not a cell, [x, y]");
    EXPECT_EQ(refusal(R"({"mission": {"air_speed": 0}})"), "request:1:27: mission.air_speed is not above 0");
    EXPECT_EQ(refusal(R"({"options": {"select": "best"}})"),
              "request:1:24: options.select is none of exact, hits, greedy, none");
    EXPECT_EQ(refusal(R"({"options": {"moves": 6}})"), "request:1:23: options.moves is neither 4 nor 8");
    EXPECT_EQ(refusal(R"({"options": {"removals": 33}})"), "request:1:26: options.removals is not between 0 and 32");
    EXPECT_EQ(refusal(R"({"plan": 1})"),
              "request:1:2: the document has a member 'plan', which is none of mission, options, methods, no_timing");
    EXPECT_EQ(refusal(R"({"methods": []})"), "request:1:13: methods names no method; leave it out for the usual ones");
    EXPECT_EQ(refusal(R"({"options": {"weights": [[1, 2], [2, 1], [1, 3]]}})"),
              "request:1:43: options.weights[2][0] has a weight already");
    EXPECT_EQ(refusal("{\n!"), "request:2:1: this is not JSON");
    EXPECT_EQ(refusal(R"({"format": "waybreaker-mission/2"})"), "request:1:12: format is not waybreaker-mission/1");
}

constexpr auto mission_file = R"({"format": "waybreaker-mission/1",
    "agents": [{"id": "robot", "kind": "ground", "start": [0, 0], "goal": [2, 0], "radius": 0},
               {"id": "drone", "kind": "air", "start": [4, 0], "goal": [0, 0], "speed": 3}],
    "rules": {"removals": 2, "breach_time": 5}, "method": {"explain": true}, "limits": {"seconds": 2}})";

TEST(PlanRequest, TakesAMissionFile) {
    const std::string inside = fmt::format(R"({{"mission": {}, "options": {{"removals": 1}}}})", mission_file);
    for (const std::string& text : {std::string(mission_file), inside}) {
        const PlanRequest request = parse_plan_request(text);
        const io::MissionDocument asked = on_map(request.mission, request.options, three_cells()).asked;
        ASSERT_EQ(asked.mission.agents.size(), 2U);
        EXPECT_EQ(asked.mission.agents[0].id, "robot");
        EXPECT_EQ(asked.mission.agents[0].body, point_body);
        EXPECT_EQ(asked.mission.agents[1].speed, 3);
        EXPECT_EQ(asked.mission.rules.breach_time.per_obstacle, 5);
        EXPECT_EQ(asked.mission.rules.removals, text == inside ? 1 : 2) << "options override";
        EXPECT_TRUE(asked.method.explain);
        EXPECT_EQ(asked.limits.seconds, 2);
    }
}

// The same as `waybreaker plan --mission`.
TEST(PlanRequest, KeepsThePlannerAndTheRemovalsOfAMissionFile) {
    const auto asked = [](const std::string& method, const std::string& options) {
        const PlanRequest request = parse_plan_request(fmt::format(
            R"({{"mission": {{"format": "waybreaker-mission/1", "agents": [
                {{"id": "a", "kind": "ground", "start": [0, 0], "goal": [2, 0]}}], "method": {}}}, "options": {}}})",
            method, options));
        return on_map(request.mission, request.options, three_cells()).asked;
    };
    EXPECT_EQ(asked(R"({"weight": 1.5})", "{}").method.planner, Algorithm::optimal);
    EXPECT_EQ(asked("{}", R"({"weight": 1.5})").method.planner, Algorithm::theta);
    EXPECT_EQ(asked(R"({"planner": "astar"})", "{}").method.planner, Algorithm::astar);
    EXPECT_EQ(asked("{}", R"({"budget": 1})").mission.rules.removals, Rules().removals);
}

TEST(PlanRequest, ProtectsByTag) {
    io::MapFile map = three_cells();
    map.annotations.tags = {{"building=church", {{2}}}};
    const auto kept = [&map](const std::string& protect) {
        const PlanRequest request = parse_plan_request(fmt::format(
            R"({{"mission": {{"start": [0, 0], "goal": [2, 0]}}, "options": {{"protect": [{}]}}}})", protect));
        return on_map(request.mission, request.options, map).asked.mission.rules.protect;
    };
    EXPECT_EQ(kept("1"), (std::vector<ObstacleId>{{1}}));
    EXPECT_EQ(kept(R"("building", 1)"), (std::vector<ObstacleId>{{1}, {2}}));
    EXPECT_EQ(kept(R"("building=church,chapel")"), (std::vector<ObstacleId>{{2}}));
    EXPECT_NE(input_error([&] { kept(R"("building=chapel")"); }), "");
}

TEST(PlanRequest, AVariantMayCountWhereTheOthersHaveABudget) {
    const PlanRequest request = parse_plan_request(
        R"({"mission": {"start": [0, 0], "goal": [2, 0]}, "options": {"budget": 2},
            "methods": [{"name": "a", "options": {"removals": 1}}, {"name": "b", "options": {}}]})");
    const auto removals = [&](std::size_t i) {
        return on_map(request.mission, request.variants[i].options, three_cells()).asked.mission.rules.removals;
    };
    EXPECT_EQ(removals(0), 1);
    EXPECT_EQ(removals(1), 2);
}

}  // namespace
}  // namespace waybreaker::request
