// Plan files: the keys of the contract, in its order, and nothing that a JSON reader would refuse.
#include "io/plan_json.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "ascii_map.hpp"
#include "io/plan_file.hpp"

namespace waybreaker::io {
namespace {

using Json = nlohmann::ordered_json;
using Keys = std::vector<std::string>;

Keys keys(const Json& object) {
    Keys found;
    for (const auto& [key, value] : object.items()) found.push_back(key);
    return found;
}

// No member of that name at any depth.
bool has_key(const Json& json, const std::string& name) {
    if (json.is_object() && json.contains(name)) return true;
    return std::any_of(json.begin(), json.end(),
                       [&](const Json& value) { return value.is_structured() && has_key(value, name); });
}

class PlanJson : public testing::Test {
  protected:
    PlanJson() {
        mission.rules.removals = 1;
        follow_paper(mission.rules, method);
        plan.before.air().length = 0;
        plan.status = PlanStatus::solved;
        plan.before.ground().length = 5.5;
        plan.before.ground().expanded = 7;
        plan.before.ground().generated = 9;
        plan.before.makespan = 5.5;
        plan.before.flowtime = 8.5;
        plan.before.ground_makespan = 5.5;
        plan.after.ground().length = 4.5;
        plan.after.air().length = 3;
        plan.after.makespan = 4.5;
        plan.after.flowtime = 7.5;
        plan.after.ground_makespan = 4.5;
        plan.breaches = {
            {.obstacle = ObstacleId{1}, .cells = 2, .hits = 11, .at = {2, 0}, .cleared_at = 1.25, .entered_at = {}}};
        plan.agents = {{"ground", AgentKind::ground, 1, {{0, 0, 0}, {4, 1.5, 4.5}}, {0, 0}, {4, 2}},
                       {"air", AgentKind::air, 2, {{0, 0, 0}, {4, 2, 2.25}}, {0, 0}, {4, 2}}};
    }
    std::string text() const { return plan_json(plan, {file, {mission, method}, Connectivity::eight, timing_fields}); }
    Json json() const { return Json::parse(text()); }

    Plan plan;
    MapFile file{.map = map_from_ascii(".#...\n.#...\n....."),
                 .source = "town.map",
                 .format = "MovingAI map",
                 .digest = "sha256:00",
                 .georeference = {},
                 .annotations = {},
                 .task = {}};
    Mission mission = ground_and_air({0, 0}, {4, 2});
    Method method;
    bool timing_fields = true;
};

TEST_F(PlanJson, HasTheKeysOfTheContractInItsOrder) {
    plan.bound = 4.0;
    const Json plan_file = json();
    EXPECT_EQ(keys(plan_file), (Keys{"format", "status", "map", "options", "mission", "before", "after", "bound",
                                     "removed", "agents", "orders", "seconds"}));
    EXPECT_EQ(keys(plan_file["map"]), (Keys{"source", "width", "height", "cell_size", "digest"}));
    EXPECT_EQ(keys(plan_file["options"]),
              (Keys{"planner", "heuristic", "weight", "tie_break", "select", "flight", "timing", "objective",
                    "removals", "breach_time", "breach_time_per_cell", "connectivity", "corners", "radius"}));
    for (const char* stage : {"before", "after"}) {
        EXPECT_EQ(keys(plan_file[stage]), (Keys{"ground", "air", "makespan", "flowtime", "ground_makespan"}));
        EXPECT_EQ(keys(plan_file[stage]["ground"]), (Keys{"length", "expanded", "generated", "seconds"}));
        EXPECT_EQ(keys(plan_file[stage]["air"]), Keys{"length"});
    }
    EXPECT_EQ(keys(plan_file["bound"]), (Keys{"makespan", "gap"}));
    EXPECT_EQ(keys(plan_file["removed"][0]), (Keys{"obstacle", "cells", "hits", "at", "cleared_at", "entered_at"}));
    EXPECT_EQ(keys(plan_file["agents"][0]), (Keys{"id", "kind", "speed", "start", "goal", "path"}));
    EXPECT_EQ(keys(plan_file["seconds"]), (Keys{"label", "search", "select", "flight", "total"}));
}

TEST_F(PlanJson, SaysWhatThePlanSays) {
    const Json plan_file = json();
    EXPECT_EQ(plan_file["format"], "waybreaker-plan/1");
    EXPECT_EQ(plan_file["status"], "solved");
    EXPECT_EQ(plan_file["map"].dump(),
              R"({"source":"town.map","width":5,"height":3,"cell_size":1.0,"digest":"sha256:00"})");
    EXPECT_EQ(plan_file["options"].dump(),
              R"({"planner":"theta","heuristic":"euclidean","weight":1.0,"tie_break":"g-max","select":"hits",)"
              R"("flight":"optimal","timing":"ignore","objective":"makespan","removals":1,"breach_time":0.0,)"
              R"("breach_time_per_cell":0.0,"connectivity":8,"corners":"none","radius":0.5})");
    EXPECT_EQ(plan_file["before"].dump(),
              R"({"ground":{"length":5.5,"expanded":7,"generated":9,"seconds":0.0},"air":{"length":0.0},)"
              R"("makespan":5.5,"flowtime":8.5,"ground_makespan":5.5})");
    EXPECT_EQ(plan_file["after"]["air"]["length"], 3);
    EXPECT_TRUE(plan_file["bound"].is_null());
    EXPECT_EQ(plan_file["removed"].dump(),
              R"([{"obstacle":1,"cells":2,"hits":11,"at":[2,0],"cleared_at":1.25,"entered_at":null}])");
    EXPECT_EQ(
        plan_file["agents"].dump(),
        R"([{"id":"ground","kind":"ground","speed":1.0,"start":[0,0],"goal":[4,2],"path":[[0,0,0.0],[4,1.5,4.5]]},)"
        R"({"id":"air","kind":"air","speed":2.0,"start":[0,0],"goal":[4,2],"path":[[0,0,0.0],[4,2,2.25]]}])");
}

TEST_F(PlanJson, NamesOptionsAsTheCommandLineDoes) {
    const std::vector<std::pair<Algorithm, std::string>> planners{
        {Algorithm::theta, "theta"}, {Algorithm::lazy_theta, "lazy-theta"}, {Algorithm::astar, "astar"},
        {Algorithm::jps, "jps"},     {Algorithm::dijkstra, "dijkstra"},     {Algorithm::bfs, "bfs"}};
    for (const auto& [planner, name] : planners) {
        method.planner = planner;
        EXPECT_EQ(json()["options"]["planner"], name);
    }
    const std::vector<std::pair<Corners, std::string>> corner_rules{
        {Corners::none, "none"}, {Corners::cut, "cut"}, {Corners::squeeze, "squeeze"}};
    for (const auto& [corners, name] : corner_rules) {
        mission.agents[0].body.corners = corners;
        EXPECT_EQ(json()["options"]["corners"], name);
    }
    const std::vector<std::pair<PlanStatus, std::string>> states{{PlanStatus::solved, "solved"},
                                                                 {PlanStatus::no_plan, "no_plan"},
                                                                 {PlanStatus::not_found, "not_found"},
                                                                 {PlanStatus::limit_reached, "limit_reached"},
                                                                 {PlanStatus::stopped, "stopped"}};
    for (const auto& [status, name] : states) {
        plan.status = status;
        EXPECT_EQ(json()["status"], name);
    }
    method.flight = FlightRule::nearest;
    EXPECT_EQ(json()["options"]["flight"], "nearest");
}

TEST_F(PlanJson, HasNullForWhatIsNotThereOrNotFinite) {
    plan.before.ground().length = std::nullopt;
    plan.before.makespan = std::numeric_limits<double>::infinity();
    plan.before.flowtime = std::numeric_limits<double>::quiet_NaN();
    plan.agents.clear();
    plan.breaches.clear();
    const Json plan_file = json();
    EXPECT_TRUE(plan_file["before"]["ground"]["length"].is_null());
    EXPECT_TRUE(plan_file["before"]["makespan"].is_null());
    EXPECT_TRUE(plan_file["before"]["flowtime"].is_null());
    EXPECT_EQ(plan_file["agents"].dump(), "[]");
    EXPECT_EQ(plan_file["removed"].dump(), "[]");
}

TEST_F(PlanJson, ProvesHowFarThePlanMayBeFromTheBest) {
    plan.bound = 4.0;
    plan.gap = 0.125;
    EXPECT_EQ(json()["bound"].dump(), R"({"makespan":4.0,"gap":0.125})");
    mission.rules.objective = Objective::flowtime;
    plan.bound = 7.5;
    plan.gap = 0;
    EXPECT_EQ(json()["bound"].dump(), R"({"flowtime":7.5,"gap":0.0})");
    plan.gap = std::nullopt;
    EXPECT_EQ(json()["bound"].dump(), R"({"flowtime":7.5,"gap":null})");
}

TEST_F(PlanJson, NamesTheSourceOfARemovedObstacleWhereItIsKnown) {
    plan.breaches[0].source_id = -42;
    plan.breaches[0].entered_at = 2.5;
    const Json removed = json()["removed"][0];
    EXPECT_EQ(removed["source_id"], -42);
    EXPECT_EQ(removed["entered_at"], 2.5);
}

TEST_F(PlanJson, HasTheNamesOfObstaclesThatHaveOne) {
    EXPECT_FALSE(has_key(json(), "name"));
    plan.next = {{.obstacle = {2}, .source_id = 0, .saves = 0.5}};
    file.annotations.names = {"", "Town \"Hall\"", ""};
    EXPECT_EQ(json()["removed"][0]["name"], "Town \"Hall\"");
    EXPECT_EQ(keys(json()["next"][0]), (Keys{"obstacle", "saves"}));
    file.annotations.names = {"", "", "Mill"};
    EXPECT_FALSE(has_key(json()["removed"], "name"));
    EXPECT_EQ(json()["next"][0]["name"], "Mill");
    const PlanFile read = parse_plan(text(), "plan.json");
    EXPECT_EQ(read.plan.next[0].obstacle, ObstacleId{2});
}

TEST_F(PlanJson, NamesWhatOnlySomeMissionsHave) {
    for (const char* key : {"protect", "budget"}) EXPECT_FALSE(has_key(json()["options"], key));
    EXPECT_FALSE(has_key(json(), "next"));
    mission.rules.timing = Timing::enforce;
    method.select = Selection::exact;
    mission.rules.breach_time = {1.5, 0.25};
    mission.rules.protect = {{1}, {2}};
    mission.rules.budget = 4;
    file.map = file.map.with_weights(std::vector<double>{0, 2.5});
    method.heuristic = Heuristic::octile;
    method.tie_break = TieBreak::g_min;
    plan.breaches[0].saves = 3.5;
    plan.breaches[0].if_failed = IfFailed{std::numeric_limits<double>::infinity()};
    plan.next = {{.obstacle = {2}, .source_id = 77, .saves = 0.5}};
    const Json written = json()["options"];
    EXPECT_EQ(written["timing"], "enforce");
    EXPECT_EQ(written["select"], "exact");
    EXPECT_EQ(written["breach_time"], 1.5);
    EXPECT_EQ(written["breach_time_per_cell"], 0.25);
    EXPECT_EQ(written["protect"].dump(), "[1,2]");
    EXPECT_EQ(written["budget"], 4.0);
    EXPECT_EQ(written["heuristic"], "octile");
    EXPECT_EQ(written["tie_break"], "g-min");
    EXPECT_EQ(json()["removed"][0]["saves"], 3.5);
    EXPECT_EQ(json()["removed"][0]["if_failed"].dump(), R"({"objective":null,"removed":[]})");
    plan.breaches[0].if_failed = IfFailed{7.5, {{2}, {4}}};
    EXPECT_EQ(json()["removed"][0]["if_failed"].dump(), R"({"objective":7.5,"removed":[2,4]})");
    EXPECT_EQ(json()["removed"][0]["weight"], 2.5);
    EXPECT_EQ(json()["next"].dump(), R"([{"obstacle":2,"source_id":77,"saves":0.5}])");
}

TEST_F(PlanJson, SaysWhatIsDestroyedWhereTheMapHasMetresOrSections) {
    for (const char* key : {"demolition", "area_m2", "structures"}) EXPECT_FALSE(has_key(json(), key)) << key;
    file.cell_size = 2.5;
    EXPECT_EQ(json()["removed"][0]["area_m2"], 12.5);
    EXPECT_EQ(json()["demolition"].dump(), R"({"removals":1,"cells":2,"area_m2":12.5})");
    file.cell_size = 2.4;
    EXPECT_EQ(file.square_metres(6641), 38252.16) << "and not 38252.159999999996";
    file.cell_size = 1;
    file.annotations.sections = {.structures = {{site::ObstacleKind::building, 7, "Mill"},
                                                {site::ObstacleKind::barrier, 0, ""},
                                                {site::ObstacleKind::building, 9, "Barn"}},
                                 .parts = {{}, {0, 1}}};
    EXPECT_EQ(json()["removed"][0]["structures"].dump(),
              R"([{"kind":"building","source_id":7,"name":"Mill"},{"kind":"barrier"}])");
    EXPECT_EQ(json()["demolition"].dump(), R"({"removals":1,"cells":2,"structures":2})");
}

TEST_F(PlanJson, NamesABudgetOfSquareMetres) {
    mission.rules.budget = 40;
    const auto written = [&](bool area) {
        return Json::parse(
            plan_json(plan, {.map = file, .asked = {.mission = mission, .method = method, .area_budget = area}}));
    };
    EXPECT_EQ(written(true)["options"]["budget_m2"], 40.0);
    EXPECT_EQ(written(true)["mission"]["rules"]["budget_m2"], 40.0);
    EXPECT_FALSE(has_key(written(true), "budget"));
    EXPECT_FALSE(has_key(written(false), "budget_m2"));
    EXPECT_TRUE(parse_plan(written(true).dump(), "p.json").asked.area_budget);
    EXPECT_FALSE(parse_plan(written(false).dump(), "p.json").asked.area_budget);
}

TEST_F(PlanJson, HasNoSecondsWithoutTimingFields) {
    EXPECT_TRUE(has_key(json(), "seconds"));
    timing_fields = false;
    EXPECT_FALSE(has_key(json(), "seconds"));
}

TEST_F(PlanJson, IsWrittenForPeople) {
    timing_fields = false;
    EXPECT_EQ(text(),
              R"({
  "format": "waybreaker-plan/1",
  "status": "solved",
  "map": {"source": "town.map", "width": 5, "height": 3, "cell_size": 1.0, "digest": "sha256:00"},
  "options": {"planner": "theta", "heuristic": "euclidean", "weight": 1.0, "tie_break": "g-max", "select": "hits", "flight": "optimal", "timing": "ignore", "objective": "makespan", "removals": 1, "breach_time": 0.0, "breach_time_per_cell": 0.0, "connectivity": 8, "corners": "none", "radius": 0.5},
  "mission": {"format": "waybreaker-mission/1", "agents": [
      {"id": "ground", "kind": "ground", "start": [0, 0], "goal": [4, 2], "speed": 1.0, "radius": 0.5, "corners": "none"},
      {"id": "air", "kind": "air", "start": [0, 0], "goal": [4, 2], "speed": 1.0}
    ], "rules": {"removals": 1, "protect": [], "force": [], "breach_time": 0.0, "breach_time_per_cell": 0.0, "timing": "ignore", "objective": "makespan"}, "method": {"select": "hits", "flight": "optimal", "planner": "theta", "weight": 1.0, "tie_break": "g-max", "moves": 8, "bound": false, "explain": false}},
  "before": {"ground": {"length": 5.5, "expanded": 7, "generated": 9}, "air": {"length": 0.0}, "makespan": 5.5, "flowtime": 8.5, "ground_makespan": 5.5},
  "after": {"ground": {"length": 4.5, "expanded": 0, "generated": 0}, "air": {"length": 3.0}, "makespan": 4.5, "flowtime": 7.5, "ground_makespan": 4.5},
  "bound": null,
  "removed": [
    {"obstacle": 1, "cells": 2, "hits": 11, "at": [2, 0], "cleared_at": 1.25, "entered_at": null}
  ],
  "agents": [
    {"id": "ground", "kind": "ground", "speed": 1.0, "start": [0, 0], "goal": [4, 2], "path": [[0, 0, 0.0], [4, 1.5, 4.5]]},
    {"id": "air", "kind": "air", "speed": 2.0, "start": [0, 0], "goal": [4, 2], "path": [[0, 0, 0.0], [4, 2, 2.25]]}
  ],
  "orders": []
}
)");
}

TEST_F(PlanJson, SurvivesNamesThatAreNotText) {
    file.source = "town\xff\"\n.map";
    EXPECT_EQ(json()["map"]["source"], "town\xEF\xBF\xBD\"\n.map");
}

}  // namespace
}  // namespace waybreaker::io
