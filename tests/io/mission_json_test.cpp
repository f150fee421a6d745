// Mission files come back as they were written; others are refused in one line that says where and why.
#include "io/mission_json.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

#include "input_error.hpp"
#include "random_map.hpp"

namespace waybreaker::io {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

std::vector<ObstacleId> any_ids() {
    std::vector<ObstacleId> ids;
    for (int i = *number(0, 3); i > 0; --i) ids.push_back({std::uint32_t(*number(1, 9))});
    return ids;
}

site::OverlayUse any_use() {
    return site::OverlayUse(*number(0, int(site::overlay_use_words.size()) - 1));
}

// Maybe it is on its way already.
void set_out(Agent& agent) {
    const bool aside = *rc::gen::arbitrary<bool>();
    if (aside && agent.kind == AgentKind::air) agent.from = Point(agent.start.x + 0.125, agent.start.y);
    agent.ready_at = *rc::gen::element(0.0, 2.5);
    const Point start = agent.begin();
    if (*rc::gen::arbitrary<bool>()) agent.approach = {{0.1, 0, 0.5}, {start.x, start.y, agent.ready_at}};
}

// Maybe it is not able to breach everything, and needs its own time.
void limit(Agent& agent) {
    agent.breach_time = *rc::gen::element(std::optional<double>(), std::optional(2.5));
    agent.breach_time_per_cell = *rc::gen::element(std::optional<double>(), std::optional(0.0), std::optional(0.1));
    if (agent.kind == AgentKind::ground) agent.reach = *rc::gen::element(1.0, 0.0, 3.5);
    if (*rc::gen::arbitrary<bool>()) return;
    agent.can_breach.emplace();
    if (*rc::gen::arbitrary<bool>()) agent.can_breach->most_cells = std::uint32_t(*number(1, 99));
    if (*rc::gen::arbitrary<bool>()) agent.can_breach->only = any_ids();
}

MissionDocument any_document() {
    MissionDocument document;
    for (int i = *number(1, 3); i > 0; --i) {
        const AgentKind kind = *rc::gen::element(AgentKind::ground, AgentKind::air);
        document.mission.agents.push_back({.id = *rc::gen::element<std::string>("ground", "drone \"7\"", ""),
                                           .kind = kind,
                                           .start = {*number(-3, 9), *number(0, 9)},
                                           .goal = {*number(0, 9), *number(0, 9)},
                                           .speed = *rc::gen::element(1.0, 0.1, 3e5)});
        document.mission.agents.back().weight = *rc::gen::element(1.0, 0.0, 2.5);
        if (kind == AgentKind::air) document.mission.agents.back().breaches = *rc::gen::element(any_number, 0, 3);
        document.mission.agents.back().range = *rc::gen::element(infinity, 900.5);
        document.mission.agents.back().endurance = *rc::gen::element(infinity, 60.0);
        document.mission.agents.back().reserve = *rc::gen::element(0.0, 0.2);
        document.mission.agents.back().flown = *rc::gen::element(0.0, 12.5);
        if (kind == AgentKind::ground)
            document.mission.agents.back().body = {*rc::gen::element(0.5, 0.0, 1.25), any_corners()};
        set_out(document.mission.agents.back());
        limit(document.mission.agents.back());
        document.mission.agents.back().recharge = *rc::gen::element(std::optional<double>(), std::optional(30.0));
        if (*rc::gen::arbitrary<bool>()) document.mission.agents.back().bases = {{3, 4}, {-1, 0}};
        const std::optional<CanBreach>& can = document.mission.agents.back().can_breach;
        if (can && can->only && *rc::gen::arbitrary<bool>())
            document.can_breach_tags[document.mission.agents.size() - 1] = {{"building", {"shed", "gar*"}}};
    }
    document.mission.rules = {
        .removals = *number(0, 9),
        .budget = *rc::gen::element(2.5, 0.0, infinity),
        .protect = any_ids(),
        .force = any_ids(),
        .breach_time = {*rc::gen::element(0.0, 0.1), *rc::gen::element(0.0, 7.0)},
        .timing = *rc::gen::element(Timing::enforce, Timing::ignore),
        .objective = *rc::gen::element(Objective::makespan, Objective::flowtime, Objective::ground_makespan)};
    if (*rc::gen::arbitrary<bool>()) document.mission.rules.opened = {{{4}, 0}, {{2}, 12.25}};
    document.mission.rules.collisions = *rc::gen::arbitrary<bool>();
    document.mission.rules.unreached = *rc::gen::element(std::optional<double>(), std::optional(600.5));
    document.method = {.select = *rc::gen::element(Selection::exact, Selection::hits),
                       .flight = *rc::gen::element(FlightRule::optimal, FlightRule::nearest),
                       .planner = *rc::gen::element(Algorithm::optimal, Algorithm::theta, Algorithm::jps),
                       .heuristic = *rc::gen::element(std::optional<Heuristic>(), std::optional(Heuristic::octile)),
                       .weight = *rc::gen::element(1.0, 1.1),
                       .tie_break = *rc::gen::element(TieBreak::g_max, TieBreak::g_min),
                       .diagonal = *rc::gen::arbitrary<bool>(),
                       .bound = *rc::gen::arbitrary<bool>(),
                       .explain = *rc::gen::arbitrary<bool>()};
    document.limits.seconds = *rc::gen::element(10.0, 0.25, infinity);
    document.mission.rules.rubble = *rc::gen::element(0.0, 0.0, 12.5);
    document.mission.rules.minimise_demolition = *rc::gen::element(std::optional<double>(), std::optional(0.01));
    document.in_seconds = *rc::gen::arbitrary<bool>();
    if (*rc::gen::arbitrary<bool>()) document.protect_tags = {{"amenity", {"school", "a \"b*"}}, {"historic"}};
    document.area_budget = std::isfinite(document.mission.rules.budget) && *rc::gen::arbitrary<bool>();
    document.map = *rc::gen::element<std::string>("", "maps/city \"7\".tif");
    if (*rc::gen::arbitrary<bool>()) {
        document.overlays = {{"flood.geojson", site::OverlayUse::water}, {"a \"b\".shp", any_use(), 2.5}};
    }
    document.limits.gap = *rc::gen::element(0.0, 0.01);
    document.limits.expansions = *rc::gen::element<std::uint64_t>(1, 1000, UINT64_MAX);
    return document;
}

RC_GTEST_PROP(MissionFile, ComesBackAsItWasWritten, ()) {
    const MissionDocument written = any_document();
    const std::string text = mission_text(written);
    const MissionDocument read = parse_mission(text, "m.json", {.seconds = 3});
    RC_ASSERT(mission_text(read) == text);
    RC_ASSERT(read.mission.agents.size() == written.mission.agents.size());
    for (std::size_t i = 0; i < read.mission.agents.size(); ++i) {
        const Agent& a = read.mission.agents[i];
        const Agent& b = written.mission.agents[i];
        RC_ASSERT(a.id == b.id && a.kind == b.kind && a.start == b.start && a.goal == b.goal);
        RC_ASSERT(a.speed == b.speed && a.body == b.body && a.breaches == b.breaches);
        RC_ASSERT(a.range == b.range && a.endurance == b.endurance && a.reserve == b.reserve && a.flown == b.flown);
        RC_ASSERT(a.recharge == b.recharge && a.bases == b.bases && a.reach == b.reach);
        RC_ASSERT(a.breach_time == b.breach_time && a.breach_time_per_cell == b.breach_time_per_cell);
        RC_ASSERT(a.can_breach.has_value() == b.can_breach.has_value());
        if (a.can_breach) RC_ASSERT(a.can_breach->most_cells == b.can_breach->most_cells);
        if (a.can_breach) RC_ASSERT(a.can_breach->only == b.can_breach->only);
        RC_ASSERT(a.ready_at == b.ready_at && a.from == b.from && a.approach == b.approach);
    }
    RC_ASSERT(read.can_breach_tags.size() == written.can_breach_tags.size());
    for (const auto& [agent, tags] : written.can_breach_tags)
        RC_ASSERT(read.can_breach_tags.at(agent).front().text() == tags.front().text());
    const Rules& rules = read.mission.rules;
    RC_ASSERT(rules.removals == written.mission.rules.removals);
    RC_ASSERT(rules.budget == written.mission.rules.budget);
    RC_ASSERT(read.area_budget == written.area_budget);
    RC_ASSERT(read.overlays == written.overlays);
    RC_ASSERT(rules.protect == written.mission.rules.protect);
    RC_ASSERT(read.in_seconds == written.in_seconds);
    RC_ASSERT(rules.rubble == written.mission.rules.rubble);
    RC_ASSERT(rules.minimise_demolition == written.mission.rules.minimise_demolition);
    RC_ASSERT(read.protect_tags.size() == written.protect_tags.size());
    for (std::size_t i = 0; i < read.protect_tags.size(); ++i) {
        RC_ASSERT(read.protect_tags[i].text() == written.protect_tags[i].text());
    }
    RC_ASSERT(rules.force == written.mission.rules.force);
    RC_ASSERT(rules.opened == written.mission.rules.opened);
    RC_ASSERT(rules.breach_time.per_obstacle == written.mission.rules.breach_time.per_obstacle);
    RC_ASSERT(rules.breach_time.per_cell == written.mission.rules.breach_time.per_cell);
    RC_ASSERT(rules.timing == written.mission.rules.timing);
    RC_ASSERT(rules.objective == written.mission.rules.objective);
    RC_ASSERT(read.method.select == written.method.select);
    RC_ASSERT(read.method.flight == written.method.flight);
    RC_ASSERT(read.method.planner == written.method.planner);
    RC_ASSERT(read.method.heuristic == written.method.heuristic);
    RC_ASSERT(read.method.weight == written.method.weight);
    RC_ASSERT(read.method.tie_break == written.method.tie_break);
    RC_ASSERT(read.method.diagonal == written.method.diagonal);
    RC_ASSERT(read.method.bound == written.method.bound);
    RC_ASSERT(read.method.explain == written.method.explain);
    RC_ASSERT(read.limits.seconds == written.limits.seconds);
    RC_ASSERT(read.limits.gap == written.limits.gap);
    RC_ASSERT(read.limits.expansions == written.limits.expansions);
}

constexpr auto agents = R"("agents": [{"id": "a", "kind": "ground", "start": [1, 2], "goal": [3, 4]}])";

std::string with(const std::string& members) {
    return R"({"format": "waybreaker-mission/1", )" + members + "}";
}

TEST(MissionFile, HasDefaultsForWhatItLeavesOut) {
    const MissionDocument read = parse_mission(with(agents), "m.json", {.seconds = 3});
    ASSERT_EQ(read.mission.agents.size(), 1U);
    EXPECT_EQ(read.mission.agents[0].speed, 1);
    EXPECT_EQ(read.mission.agents[0].body, Body());
    EXPECT_EQ(read.mission.rules.removals, Rules().removals);
    EXPECT_EQ(read.method.select, Selection::exact);
    EXPECT_EQ(read.limits.seconds, 3);
    EXPECT_EQ(
        parse_mission(with(agents + std::string(R"(, "page": {"map": "a.map"})")), "m.json").mission.agents.size(), 1U);
    EXPECT_EQ(parse_mission(with(agents + std::string(R"(, "limits": {"seconds": null})")), "m.json", {.seconds = 3})
                  .limits.seconds,
              infinity);
}

TEST(MissionFile, IsRefusedWithPlaceAndReason) {
    const auto refusal = [](const std::string& text) { return input_error([&] { parse_mission(text, "m.json"); }); };
    EXPECT_EQ(refusal("{"), "m.json:1:2: this is not JSON: it ends too early");
    EXPECT_EQ(refusal("{}"),
              "m.json:1:1: the document has no member format: give it \"format\": \"waybreaker-mission/1\"");
    EXPECT_EQ(refusal(R"({"format": "waybreaker-plan/1"})"), "m.json:1:12: format is not waybreaker-mission/1");
    EXPECT_EQ(refusal(with(R"("agents": {})")), "m.json:1:46: agents is not an array");
    EXPECT_EQ(refusal(with(R"("agents": [])")),
              "m.json:1:46: agents names nobody: a mission has at least one ground agent");
    EXPECT_EQ(refusal(with(R"("agents": [{"id": "a"}])")), "m.json:1:47: agents[0] has no member kind");
    const auto agent = [](const std::string& member) {
        return with(R"("agents": [{"id": "a", "kind": "ground", "start": [1, 2], "goal": [3, 4], )" + member + "}]");
    };
    EXPECT_EQ(refusal(agent(R"("speed": 0)")), "m.json:1:119: agents[0].speed is not between 1e-06 and 1e+06");
    EXPECT_EQ(refusal(agent(R"("ready_at": 1e10)")), "m.json:1:122: agents[0].ready_at is not between 0 and 1e+09");
    EXPECT_EQ(refusal(agent(R"("approach": [[1, 2]])")), "m.json:1:123: agents[0].approach[0] is not [x, y, t]");
    EXPECT_EQ(refusal(agent(R"("reach": -1)")), "m.json:1:119: agents[0].reach is not between 0 and 100");
    EXPECT_EQ(refusal(agent(R"("can_breach": {"most_cells": 0})")),
              "m.json:1:139: agents[0].can_breach.most_cells is not between 1 and 4294967295");
    EXPECT_EQ(refusal(agent(R"("can_breach": {"only": ["=b"]})")).substr(0, 60),
              "m.json:1:134: agents[0].can_breach.only[0] is no tag: '=b' i");
    EXPECT_EQ(refusal(with(R"("agents": [{"id": "a", "kind": "ground", "start": [1.5, 2], "goal": [3, 4]}])")),
              "m.json:1:87: agents[0].start[0] is not a whole number");
    const auto says = [&](const std::string& members) {
        const std::string error = refusal(with(agents + (", " + members)));
        return error.substr(error.find(' ') + 1);
    };
    const auto named = [](const std::string& id) {
        return with(R"("agents": [{"id": ")" + id + R"(", "kind": "ground", "start": [1, 2], "goal": [3, 4]}])");
    };
    std::string hundred;
    for (int i = 0; i < 100; ++i) hundred += "é";
    EXPECT_EQ(refusal(named(hundred)), "");
    EXPECT_EQ(refusal(named(hundred + "x")), "m.json:1:54: agents[0].id has more than 100 characters");
    EXPECT_EQ(refusal(named("a\u202eb")), "m.json:1:54: agents[0].id holds control characters");
    EXPECT_EQ(says(R"("removals": 2)"),
              "the document has a member 'removals', which is none of format, map, overlays, time_unit, agents, rules, "
              "method, limits, "
              "page");
    EXPECT_EQ(says(R"("rules": {"removals": -1})"), "rules.removals is not between 0 and 2147483647");
    EXPECT_EQ(says(R"("rules": {"protect": [0]})"), "rules.protect[0] is not between 1 and 4294967295");
    EXPECT_EQ(says(R"("rules": {"protect": [1, "=b"]})"),
              "rules.protect[1] is no tag: '=b' is no filter for tags: a filter is KEY or KEY=VALUE,... such as "
              "barrier=wall,fence");
    EXPECT_EQ(says(R"("rules": {"minimise_demolition": 1e300})"), "rules.minimise_demolition is not between 0 and 1");
    EXPECT_EQ(says(R"("rules": {"breach_time": 1e300})"), "rules.breach_time is not between 0 and 1e+09");
    EXPECT_EQ(says(R"("rules": {"breach_time_per_cell": -1})"),
              "rules.breach_time_per_cell is not between 0 and 1e+09");
    EXPECT_EQ(says(R"("rules": {"separation": 33})"), "rules.separation is not between 0 and 32");
    EXPECT_EQ(says(R"("method": {"weight": 0})"), "method.weight is not between 1 and 1e+06");
    EXPECT_EQ(says(agents), "the member 'agents' is there twice");
    EXPECT_EQ(says(R"("overlays": [{"file": "a.shp"}])"), "overlays[0] has no member as");
    EXPECT_EQ(says(R"("overlays": [{"file": "a.shp", "as": "lava"}])"),
              "overlays[0].as is none of water, debris, closed, wall, free");
    EXPECT_EQ(says(R"("overlays": [{"file": "", "as": "water"}])"), "overlays[0].file is empty");
    EXPECT_EQ(says(R"("time_unit": "h")"), "time_unit is not s");
    EXPECT_EQ(says(R"("rules": {"timing": "never"})"), "rules.timing is none of enforce, ignore");
    EXPECT_EQ(says(R"("rules": {"budget": 1, "budget_m2": 1})"),
              "rules.budget_m2 stands beside budget; give one of them");
    EXPECT_EQ(says(R"("method": {"moves": 6})"), "method.moves is neither 4 nor 8");
    EXPECT_EQ(says(R"("limits": {"seconds": 0})"), "limits.seconds is not above 0");
}

}  // namespace
}  // namespace waybreaker::io
