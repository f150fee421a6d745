// Plans of every kind are as openapi.json describes them; LiveServer holds every answer against it.
#include <chrono>

#include "live_server.hpp"
#include "osm_yard.hpp"
#include "schema_check.hpp"
#include "streaming_client.hpp"

namespace waybreaker::service {
namespace {

const std::string house_path = maps + "/house.map";

Json agent(const std::string& id, const std::string& kind, const Json& start, const Json& goal) {
    return {{"id", id}, {"kind", kind}, {"start", start}, {"goal", goal}};
}

const Json robot = agent("robot", "ground", {1, 3}, {9, 3});
const Json rover = agent("rover", "ground", {9, 1}, {1, 1});
const Json drone = agent("drone", "air", {1, 1}, {9, 1});
const Json kite = agent("kite", "air", {9, 5}, {1, 5});

Json mission_of(const Json& agents, int removals = 1) {
    return {{"format", "waybreaker-mission/1"}, {"agents", agents}, {"rules", {{"removals", removals}}}};
}

std::string faults_of(const Json& plan) {
    const Json api = Json::parse(openapi_json());
    std::string all;
    for (const std::string& fault : schema_faults(api, api["components"]["schemas"]["Plan"], plan)) all += fault + '\n';
    return all;
}

class PlanKindsTest : public LiveServer {
  protected:
    // Everything that can be done with a plan.
    Json planned(const std::string& map, const Json& request) const {
        const Json plan = post_json(map + "/plan", request);
        EXPECT_EQ(post_json(map + "/check", plan)["valid"], true) << plan;
        EXPECT_EQ(post(map + "/export?format=json", plan.dump()).status, 200);
        return plan;
    }
};

TEST_F(PlanKindsTest, OnePair) {
    begin();
    EXPECT_TRUE(planned(house_path, mission_of({robot, drone}))["before"].contains("ground"));
    Json request = mission_of({robot, drone});
    request["method"] = {{"explain", true}, {"bound", true}};
    request["rules"]["breach_time"] = 2;
    EXPECT_TRUE(planned(house_path, request).contains("removed"));
    Json options = house_mission;
    options["options"].update({{"explain", true}, {"weights", "cells"}, {"budget", 10}, {"minimise_demolition", 0.1}});
    planned(house_path, options);
    options = {{"mission", mission_of({drone, robot})}, {"options", {{"removals", 0}}}, {"no_timing", true}};
    EXPECT_FALSE(planned(house_path, options).contains("seconds"));
}

TEST_F(PlanKindsTest, Teams) {
    begin();
    for (const Json& agents : {Json::array({robot}), Json::array({robot, rover}), Json::array({robot, rover, drone}),
                               Json::array({robot, rover, drone, kite}), Json::array({robot, drone, kite})}) {
        for (const bool explain : {false, true}) {
            Json request = mission_of(agents);
            request["method"] = {{"explain", explain}};
            const Json plan = planned(house_path, request);
            EXPECT_EQ(plan["status"], "solved") << agents;
            EXPECT_EQ(plan["before"]["routes"].size(), agents.size());
            EXPECT_EQ(plan["after"]["routes"][0]["id"], "robot");
        }
    }
    EXPECT_EQ(planned(house_path, mission_of({robot, rover, drone}))["removed"][0]["by"], "drone");
}

TEST_F(PlanKindsTest, NoneAtAll) {
    begin();
    const std::string wall = maps + "/wall.map";
    const Json here = agent("here", "ground", {0, 0}, {2, 0});
    const Json flies = agent("flies", "air", {0, 0}, {2, 0});
    for (const Json& agents : {Json::array({here}), Json::array({here, flies}), Json::array({here, flies, flies})}) {
        Json request = mission_of(agents, 0);
        if (agents.size() == 3) request["agents"][2]["id"] = "flies too";
        EXPECT_EQ(post_json(wall + "/plan", request)["status"], "no_plan") << agents;
    }
    // One that has a way only once something is removed.
    Json request = mission_of({here, flies, flies}, 1);
    request["agents"][2]["id"] = "flies too";
    const Json plan = planned(wall, request);
    EXPECT_TRUE(plan["before"]["makespan"].is_null());
    EXPECT_TRUE(plan["before"]["routes"][0]["length"].is_null());
    EXPECT_TRUE(plan["after"]["makespan"].is_number());
}

TEST_F(PlanKindsTest, WithoutTheTimeForThem) {
    constexpr int width = 300;
    put("maps/thicket.map", thicket(width));
    begin();
    const std::string map = maps + "/thicket.map";
    Json request = long_mission(width);
    request["options"]["time_limit"] = 0.05;
    EXPECT_EQ(post_json(map + "/plan", request)["limit_reached"], true);
    EXPECT_EQ(post_json(map + "/front", request)["format"], "waybreaker-plan/1");
    const Json last{width - 1, width - 1};
    request = mission_of(
        {agent("a", "ground", {0, 0}, last), agent("b", "ground", last, {0, 0}), agent("c", "air", {0, 0}, last)}, 20);
    for (const double seconds : {1e-6, 0.05}) {
        request["limits"] = {{"seconds", seconds}};
        const Json plan = post_json(map + "/plan", request);
        EXPECT_TRUE(plan["status"] == "limit_reached" || plan.value("limit_reached", false)) << plan["status"];
    }
}

TEST_F(PlanKindsTest, OfMapsThatSayMore) {
    begin();
    const std::string source = Json::parse(post(sources, osm_yard(), octets).body)["id"];
    const Json map = post_json(imports, {{"source", source}, {"cell", 1}, {"section", 5}}, 201);
    const std::string yard = maps + "/" + map["id"].get<std::string>();
    const int far = map["width"].get<int>() - 1;
    const Json across = {agent("a", "ground", {0, far / 2}, {far, far / 2}), agent("b", "air", {0, 0}, {far, far})};
    Json request = mission_of(across);
    request["rules"].update({{"budget_m2", 500}, {"minimise_demolition", 0.01}});
    const Json plan = planned(yard, request);
    EXPECT_TRUE(plan.contains("demolition"));
    EXPECT_GT(plan["agents"][0]["surface"]["ways"], 0);  // across the lane
    EXPECT_GT(plan["agents"][0]["surface"]["off_ways"], 0);
    EXPECT_EQ(post(yard + "/export?format=geojson", plan.dump()).status, 200);
    Json team = mission_of(across);
    team["agents"].push_back(agent("c", "ground", {far, 0}, {0, 0}));
    const Json driven = planned(yard, team);
    EXPECT_TRUE(driven.contains("demolition"));
    EXPECT_TRUE(driven["agents"][2].contains("surface"));
}

TEST_F(PlanKindsTest, FrontsComparisonsAndEvents) {
    begin();
    EXPECT_EQ(post_json(house_path + "/front", mission_of({robot, drone}))["front"].size(), 2U);
    EXPECT_EQ(post_json(house_path + "/front", mission_of({robot, rover, drone}))["front"].size(), 2U);
    Json request{{"mission", mission_of({robot, rover, drone})}};
    request["methods"] = Json::parse(R"([{"name": "none", "options": {"select": "none"}},
                                         {"name": "exact", "options": {"removals": 1}}])");
    EXPECT_EQ(post_json(house_path + "/compare", request)["plans"].size(), 2U);
    const std::string events = post(house_path + "/plan", mission_of({robot, rover, drone}).dump(), "application/json",
                                    {{"Accept", "text/event-stream"}})
                                   .body;
    std::string plan;
    std::istringstream lines(events.substr(events.find("event: plan\n")));
    for (std::string line; std::getline(lines, line);) plan += line.starts_with("data: ") ? line.substr(6) : "";
    EXPECT_EQ(faults_of(Json::parse(plan)), "");
}

TEST_F(PlanKindsTest, TheDescriptionTakesNoMixtures) {
    begin();
    Json pair = post_json(house_path + "/plan", mission_of({robot, drone}));
    Json team = post_json(house_path + "/plan", mission_of({robot, rover}));
    EXPECT_EQ(faults_of(pair) + faults_of(team), "");
    pair["after"]["routes"] = team["after"]["routes"];
    EXPECT_NE(faults_of(pair), "");
    team["before"].erase("routes");
    EXPECT_NE(faults_of(team), "");
}

}  // namespace
}  // namespace waybreaker::service
