// Plan files come back as they were written; others are refused in one line that says where and why.
#include "io/plan_file.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <regex>

#include "ascii_map.hpp"
#include "checked_plan.hpp"
#include "input_error.hpp"
#include "io/plan_json.hpp"
#include "random_map.hpp"

namespace waybreaker::io {
namespace {

using Json = nlohmann::ordered_json;

MapFile map_file(Map map) {
    return {.map = std::move(map),
            .source = "town.map",
            .format = "MovingAI map",
            .digest = "sha256:00",
            .georeference = {},
            .annotations = {},
            .task = {}};
}

void expect_same(const Outcome& written, const Outcome& read) {
    RC_ASSERT(read.ground().length == written.ground().length);
    RC_ASSERT(read.air().length == written.air().length);
    RC_ASSERT(read.makespan == written.makespan);
    RC_ASSERT(read.flowtime == written.flowtime);
    RC_ASSERT(read.ground_makespan == written.ground_makespan);
}

void expect_same(const Breach& written, const Breach& read) {
    RC_ASSERT(read.obstacle == written.obstacle);
    RC_ASSERT(read.source_id == written.source_id);
    RC_ASSERT(read.cells == written.cells);
    RC_ASSERT(read.hits == written.hits);
    RC_ASSERT(read.at == written.at);
    RC_ASSERT(read.cleared_at == written.cleared_at);
    RC_ASSERT(read.entered_at == written.entered_at);
    RC_ASSERT(read.saves == written.saves);
    RC_ASSERT(read.if_failed == written.if_failed);
    RC_ASSERT(read.by == written.by);
    RC_ASSERT(read.begun_at == written.begun_at);
}

void expect_same(const Itinerary& written, const Itinerary& read) {
    RC_ASSERT(read.id == written.id);
    RC_ASSERT(read.kind == written.kind);
    RC_ASSERT(read.speed == written.speed);
    RC_ASSERT(read.start == written.start);
    RC_ASSERT(read.goal == written.goal);
    RC_ASSERT(read.path == written.path);
    RC_ASSERT(read.gain == written.gain);
    RC_ASSERT(read.waits.size() == written.waits.size());
    for (std::size_t i = 0; i < read.waits.size(); ++i) {
        const Wait& wait = read.waits[i];
        RC_ASSERT(wait.at == written.waits[i].at);
        RC_ASSERT(wait.from == written.waits[i].from);
        RC_ASSERT(wait.until == written.waits[i].until);
        RC_ASSERT(wait.reason == written.waits[i].reason);
        RC_ASSERT(wait.obstacle == written.waits[i].obstacle);
        RC_ASSERT(wait.agent == written.waits[i].agent);
    }
}

// What pictures draw: the way of an agent, which the file says in time.
void expect_way(const Route& route, const Itinerary& agent) {
    RC_ASSERT(route.path.front() == Point(agent.start) && route.path.back() == Point(agent.goal));
    double length = 0;
    for (std::size_t i = 1; i < route.path.size(); ++i) length += distance(route.path[i - 1], route.path[i]);
    RC_ASSERT(std::abs(length - route.length.value()) < 1e-6);
}

void explain(Itinerary& agent) {
    agent.gain = *rc::gen::element(std::optional<double>(), std::optional(-0.25));
    for (int i = *number(0, 2); i > 0; --i) {
        agent.waits.push_back({{*rc::gen::element(3.0, 2.5), 4},
                               0.1,
                               7,
                               *rc::gen::element(WaitReason::nothing, WaitReason::readiness, WaitReason::opening,
                                                 WaitReason::agent, WaitReason::zone),
                               {std::uint32_t(*number(0, 3))},
                               *rc::gen::element<std::string>("", "heli \"7\""),
                               std::size_t(*number(0, 2))});
    }
}

Rules any_rules(const Map& map) {
    Rules options;
    options.removals = *number(0, 3);
    options.timing = *rc::gen::element(Timing::enforce, Timing::ignore);
    options.objective = *rc::gen::element(Objective::makespan, Objective::flowtime, Objective::ground_makespan);
    options.breach_time = {*rc::gen::element(0.0, 1.5), *rc::gen::element(0.0, 0.25)};
    options.protect = some_obstacles(map, 2);
    for (const Obstacle& obstacle : map.obstacles()) {
        const bool stays = std::ranges::count(options.protect, obstacle.id) > 0;
        if (!stays && int(options.force.size()) < std::min(options.removals, 1)) options.force.push_back(obstacle.id);
    }
    options.budget = *rc::gen::element(3.0, std::numeric_limits<double>::infinity());
    return options;
}

RC_GTEST_PROP(PlanFile, ComesBackAsItWasWritten, ()) {
    const PlainMap plain = *random_map(20, 16);
    const Map map(plain.grid());
    const double weight = *rc::gen::element(1.0, 1.5);
    const MapFile file = map_file(map.with_weights(std::vector<double>(map.obstacles().size() + 1, weight)));
    Mission mission = ground_and_air(any_free_cell(plain), any_free_cell(plain));
    mission.agents[1].speed = 3;
    mission.agents[0].body.corners = any_corners();
    mission.rules = any_rules(file.map);
    const Method method{.select = *rc::gen::element(Selection::exact, Selection::hits),
                        .weight = *rc::gen::element(1.0, 1.25),
                        .tie_break = *rc::gen::element(TieBreak::g_max, TieBreak::g_min),
                        .diagonal = *rc::gen::arbitrary<bool>(),
                        .bound = *rc::gen::arbitrary<bool>()};
    Plan plan = Planner().plan(file.map, mission, method);
    for (Breach& breach : plan.breaches) {
        breach.saves = 0.1;
        breach.if_failed = *rc::gen::element(std::optional<IfFailed>(), std::optional(IfFailed{7.5, {{1}, {2}}}),
                                             std::optional(IfFailed{std::numeric_limits<double>::infinity()}));
        breach.by = *rc::gen::element<std::string>("", "air 1");
        breach.begun_at = *rc::gen::element(std::optional<double>(), std::optional(0.3));
    }
    for (Itinerary& agent : plan.agents) explain(agent);
    plan.next = {{.obstacle = {7}, .source_id = -7, .saves = 0.7}};
    plan.barred_by = BarredBy{3, "air", 12.5};
    plan.out_of_range = {{.obstacle = {7}, .source_id = -7, .agent = "air", .flight = 1100.5, .longest = 900}};
    const PlanFile read =
        parse_plan(plan_json(plan, {file, {mission, method}, Connectivity::eight, true}), "plan.json");

    RC_ASSERT(read.width == file.map.width() && read.height == file.map.height());
    RC_ASSERT(read.digest == file.digest);
    RC_ASSERT(read.connectivity == Connectivity::eight);
    const Rules& rules = read.asked.mission.rules;
    RC_ASSERT(rules.timing == mission.rules.timing);
    RC_ASSERT(rules.breach_time.per_obstacle == mission.rules.breach_time.per_obstacle);
    RC_ASSERT(rules.breach_time.per_cell == mission.rules.breach_time.per_cell);
    RC_ASSERT(rules.objective == mission.rules.objective);
    RC_ASSERT(rules.removals == mission.rules.removals);
    RC_ASSERT(rules.protect == mission.rules.protect);
    RC_ASSERT(rules.force == mission.rules.force);
    RC_ASSERT(rules.budget == mission.rules.budget);
    RC_ASSERT(read.asked.mission.agents.size() == 2U);
    for (std::size_t i = 0; i < read.plan.agents.size(); ++i) {
        expect_way(read.plan.after.routes[i], read.plan.agents[i]);
    }
    for (std::size_t i = 0; i < 2; ++i) {
        const Agent& agent = read.asked.mission.agents[i];
        RC_ASSERT(agent.id == mission.agents[i].id && agent.kind == mission.agents[i].kind);
        RC_ASSERT(agent.start == mission.agents[i].start && agent.goal == mission.agents[i].goal);
        RC_ASSERT(agent.speed == mission.agents[i].speed && agent.body == mission.agents[i].body);
    }
    RC_ASSERT(read.asked.method.select == method.select);
    RC_ASSERT(read.asked.method.flight == method.flight);
    RC_ASSERT(read.asked.method.planner == planner_of(method, mission.agents[0].body));
    RC_ASSERT(read.asked.method.weight == method.weight);
    RC_ASSERT(read.asked.method.tie_break == method.tie_break);
    RC_ASSERT(read.asked.method.diagonal == method.diagonal);
    RC_ASSERT(read.asked.method.bound == method.bound);
    const bool weighed = weight != 1 || std::isfinite(rules.budget);
    RC_ASSERT(read.weights.size() == (weighed ? plan.breaches.size() : 0));
    for (const auto& [obstacle, stated] : read.weights) RC_ASSERT(stated == weight);
    RC_ASSERT(read.plan.gap == plan.gap);
    RC_ASSERT(read.plan.status == plan.status);
    RC_ASSERT(read.plan.bound == plan.bound);
    expect_same(plan.before, read.plan.before);
    expect_same(plan.after, read.plan.after);
    RC_ASSERT(read.plan.breaches.size() == plan.breaches.size());
    for (std::size_t i = 0; i < plan.breaches.size(); ++i) expect_same(plan.breaches[i], read.plan.breaches[i]);
    RC_ASSERT(read.plan.agents.size() == plan.agents.size());
    for (std::size_t i = 0; i < plan.agents.size(); ++i) expect_same(plan.agents[i], read.plan.agents[i]);
    RC_ASSERT(read.plan.next.size() == 1U);
    RC_ASSERT(read.plan.next[0].obstacle == plan.next[0].obstacle);
    RC_ASSERT(read.plan.next[0].source_id == plan.next[0].source_id);
    RC_ASSERT(read.plan.barred_by.has_value() && read.plan.barred_by->zone == 3);
    RC_ASSERT(read.plan.barred_by->agent == "air" && read.plan.barred_by->at == 12.5);
    RC_ASSERT(read.plan.out_of_range.size() == 1U);
    RC_ASSERT(read.plan.out_of_range[0].obstacle == plan.out_of_range[0].obstacle);
    RC_ASSERT(read.plan.out_of_range[0].source_id == plan.out_of_range[0].source_id);
    RC_ASSERT(read.plan.out_of_range[0].agent == "air");
    RC_ASSERT(read.plan.out_of_range[0].flight == 1100.5 && read.plan.out_of_range[0].longest == 900);
    RC_ASSERT(read.plan.next[0].saves == plan.next[0].saves);
}

const char* const small_plan = R"({
  "format": "waybreaker-plan/1",
  "status": "solved",
  "map": {"source": "town.map", "width": 4, "height": 1, "cell_size": 1.0, "digest": "sha256:00"},
  "options": {"timing": "enforce", "objective": "makespan", "removals": 1, "connectivity": 4, "corners": "none", "radius": 0.5},
  "before": {"ground": {"length": null}, "air": {"length": 3.0}, "makespan": null, "flowtime": null},
  "after": {"ground": {"length": 3.0}, "air": {"length": 3.0}, "makespan": 3.0, "flowtime": 6.0},
  "bound": null,
  "removed": [
    {"obstacle": 1, "cells": 1, "at": [1, 0], "cleared_at": 1.0, "entered_at": 1.0}
  ],
  "agents": [
    {"id": "ground", "kind": "ground", "speed": 1.0, "path": [[0, 0, 0.0], [3, 0, 3.0]]},
    {"id": "air", "kind": "air", "speed": 1.0, "path": [[0, 0, 0.0], [3, 0, 3.0]]}
  ]
}
)";

// What its vehicle waits for.
const Json small_order = {{"before", {{"agent", "air"}, {"point", 0}, {"fraction", 1 / 3.0}}},
                          {"after", {{"agent", "ground"}, {"point", 0}, {"fraction", 1 / 3.0}}},
                          {"why", "opening"},
                          {"obstacle", 1},
                          {"slack", 0.0}};

// The small plan with one member replaced; its place as a JSON pointer.
std::string with(const std::string& pointer, const Json& value) {
    Json json = Json::parse(small_plan);
    json[Json::json_pointer(pointer)] = value;
    return json.dump();
}
std::string without(const std::string& pointer) {
    const Json::json_pointer place(pointer);
    Json json = Json::parse(small_plan);
    json[place.parent_pointer()].erase(place.back());
    return json.dump();
}
// What stands behind the place in the text, which json_field_test.cpp sees to.
std::string plan_refusal(const std::string& bytes) {
    const std::string error = input_error([&] { parse_plan(bytes, "p.json"); });
    std::smatch parts;
    if (!std::regex_match(error, parts, std::regex("p\\.json:[1-9][0-9]*:[1-9][0-9]*: (.*)"))) return error;
    return parts[1];
}

TEST(PlanFile, IsReadAndHolds) {
    const PlanFile file = parse_plan(with("/orders", Json::array({small_order})), "p.json");
    EXPECT_TRUE(check(map_from_ascii("..#."), file.asked.mission, file.plan).empty());
    EXPECT_EQ(file.plan.agents[0].goal, (Cell{3, 0})) << "where its path ends, as nothing else is said";
}

TEST(PlanFile, MaySayNothingOfOrders) {
    EXPECT_FALSE(parse_plan(small_plan, "p.json").states_orders);
    const PlanFile file = parse_plan(with("/orders", Json::array({small_order})), "p.json");
    EXPECT_TRUE(file.states_orders);
    ASSERT_EQ(file.plan.orders.size(), 1U);
    const Order& order = file.plan.orders[0];
    EXPECT_EQ(order.before, (Moment{1, 0, 1 / 3.0}));
    EXPECT_EQ(order.after, (Moment{0, 0, 1 / 3.0}));
    EXPECT_EQ(order.reason, OrderReason::opening);
    EXPECT_EQ(order.obstacle, ObstacleId{1});
    EXPECT_EQ(order.slack, 0);
}

TEST(PlanFile, MaySayMore) {
    PlanFile file = parse_plan(with("/options/breach_time", 2), "p.json");
    EXPECT_EQ(file.asked.mission.rules.breach_time.per_obstacle, 2);
    EXPECT_EQ(parse_plan(with("/options/breach_time_per_cell", 0.5), "p.json").asked.mission.rules.breach_time.per_cell,
              0.5);
    EXPECT_EQ(parse_plan(with("/options/budget", 2.5), "p.json").asked.mission.rules.budget, 2.5);
    EXPECT_EQ(parse_plan(with("/options/protect", {3, 4}), "p.json").asked.mission.rules.protect,
              (std::vector<ObstacleId>{{3}, {4}}));
    EXPECT_EQ(parse_plan(with("/removed/0/weight", 7), "p.json").weights.at(0).weight, 7);
    EXPECT_EQ(parse_plan(with("/removed/0/saves", 7), "p.json").plan.breaches[0].saves, 7);
    EXPECT_EQ(parse_plan(with("/removed/0/source_id", INT64_MIN), "p.json").plan.breaches[0].source_id, INT64_MIN);
    EXPECT_EQ(parse_plan(with("/agents/0/goal", {2, 0}), "p.json").plan.agents[0].goal, (Cell{2, 0}));
    EXPECT_EQ(parse_plan(with("/agents/0/path/0", {1e300, -1e300, 0}), "p.json").plan.agents[0].start,
              (Cell{1000000000, -1000000000}));
    const Json next = {{{"obstacle", 2}, {"source_id", 5}, {"saves", 1.5}}};
    file = parse_plan(with("/next", next), "p.json");
    ASSERT_EQ(file.plan.next.size(), 1U);
    EXPECT_EQ(file.plan.next[0].obstacle, ObstacleId{2});
    EXPECT_EQ(file.plan.next[0].source_id, 5);
    EXPECT_EQ(file.plan.next[0].saves, 1.5);
    EXPECT_EQ(parse_plan(without("/bound"), "p.json").plan.bound, std::nullopt);
    EXPECT_EQ(parse_plan(without("/options/removals"), "p.json").asked.mission.rules.removals, INT_MAX);
    file = parse_plan(with("/bound", {{"makespan", 2.5}, {"gap", 0.2}}), "p.json");
    EXPECT_EQ(file.plan.bound, 2.5);
    EXPECT_EQ(file.plan.gap, 0.2);
}

TEST(PlanFile, IsRefusedWithPlaceAndReason) {
    EXPECT_EQ(plan_refusal("[]"), "the document is not an object");
    EXPECT_EQ(plan_refusal("{}"), "the document has no member format: give it \"format\": \"waybreaker-plan/1\"");
    EXPECT_EQ(plan_refusal(std::string(1000, '[')), "its values are nested too deep");
    EXPECT_EQ(plan_refusal(with("/format", "waybreaker-plan/2")), "format is not waybreaker-plan/1");
    EXPECT_EQ(plan_refusal(with("/status", "well")),
              "status is none of solved, no_plan, not_found, limit_reached, stopped");
    EXPECT_EQ(plan_refusal(with("/map/width", 1e9)), "map.width is not between 1 and 32768");
    EXPECT_EQ(plan_refusal(with("/options/radius", -1)), "options.radius is not between 0 and 32");
    EXPECT_EQ(plan_refusal(with("/options/breach_time", -1)), "options.breach_time is not between 0 and 1e+09");
    EXPECT_EQ(plan_refusal(with("/options/weight", 0)), "options.weight is not between 1 and 1e+06");
    EXPECT_EQ(plan_refusal(with("/options/connectivity", 5)), "options.connectivity is neither 4 nor 8");
    EXPECT_EQ(plan_refusal(without("/options/timing")), "options has no member timing");
    EXPECT_EQ(plan_refusal(with("/after/air/length", "far")), "after.air.length is not a number");
    EXPECT_EQ(plan_refusal(with("/after/air/length", nullptr)), "");  // as where zones in time let nobody through
    EXPECT_EQ(plan_refusal(with("/removed", "none")), "removed is not an array");
    EXPECT_EQ(plan_refusal(with("/removed/0/obstacle", 4294967296)),
              "removed[0].obstacle is not between 0 and 4294967295");
    EXPECT_EQ(plan_refusal(with("/removed/0/obstacle", UINT64_MAX)),
              "removed[0].obstacle is not between 0 and 4294967295");
    EXPECT_EQ(plan_refusal(with("/removed/0/cells", 1.5)), "removed[0].cells is not a whole number");
    EXPECT_EQ(plan_refusal(with("/removed/0/source_id", 1e300)), "removed[0].source_id is not a whole number");
    EXPECT_EQ(plan_refusal(with("/removed/0/at", {1, 2, 3})), "removed[0].at is not a cell, [x, y]");
    EXPECT_EQ(plan_refusal(with("/agents/1/id", "a\nb")), "agents[1].id holds control characters");
    const std::string long_id(101, 'x');
    EXPECT_EQ(plan_refusal(with("/agents/1/id", long_id)), "agents[1].id has more than 100 characters");
    EXPECT_EQ(plan_refusal(with("/removed/0/by", long_id)), "removed[0].by has more than 100 characters");
    EXPECT_EQ(plan_refusal(with("/agents/1/kind", 3)), "agents[1].kind is none of ground, air");
    EXPECT_EQ(plan_refusal(with("/agents/1/path", Json::array())), "agents[1].path is empty");
    EXPECT_EQ(plan_refusal(with("/agents/1/path/1", {1, 2})), "agents[1].path[1] is not [x, y, t]");
    const auto order_refusal = [](const std::string& pointer, const Json& value) {
        Json order = small_order;
        order[Json::json_pointer(pointer)] = value;
        return plan_refusal(with("/orders", Json::array({order})));
    };
    EXPECT_EQ(order_refusal("/before/agent", "nobody"), "orders[0].before.agent is no agent of the plan");
    EXPECT_EQ(order_refusal("/before/point", 2), "orders[0].before.point is not between 0 and 1");
    EXPECT_EQ(order_refusal("/after/point", 1), "orders[0].after.fraction is beyond the last point of the path");
    EXPECT_EQ(order_refusal("/after/fraction", 1), "orders[0].after.fraction is not at least 0 and below 1");
    EXPECT_EQ(order_refusal("/why", "luck"), "orders[0].why is none of opening, passing");
    EXPECT_EQ(order_refusal("/slack", nullptr), "orders[0].slack is not a number");
    EXPECT_EQ(plan_refusal(with("/agents/1/path/1/2", "late")), "agents[1].path[1][2] is not a number");
}

}  // namespace
}  // namespace waybreaker::io
