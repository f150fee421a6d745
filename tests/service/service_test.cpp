// The routes: their responses.
#include <algorithm>

#include "live_server.hpp"
#include "streaming_client.hpp"

namespace waybreaker::service {
namespace {

class ServiceTest : public LiveServer {};

const std::string house = maps + "/house.map";

TEST_F(ServiceTest, ListsAndDescribesTheMapsOfItsFolder) {
    begin();
    EXPECT_EQ(get_json(maps),
              Json::parse(R"({"maps": [{"id": "berlin-adlershof.tif", "uploaded": false, "loaded": false},
                                                       {"id": "berlin-mitte.tif", "uploaded": false, "loaded": false},
                                                       {"id": "house.map", "uploaded": false, "loaded": false},
                                                       {"id": "wall.map", "uploaded": false, "loaded": false}]})"));
    const Json map = get_json(house);
    EXPECT_EQ(map["width"], 11);
    EXPECT_EQ(map["height"], 7);
    EXPECT_EQ(map["obstacles"]["count"], 1);
    EXPECT_TRUE(get_json(maps)["maps"][2]["loaded"]);
    get_json(maps + "/nowhere.map", 404);
}

TEST_F(ServiceTest, HasMapsOfItsOwn) {
    options_.maps = "";
    begin();
    EXPECT_EQ(get_json(maps),
              Json::parse(R"({"maps": [{"id": "berlin-adlershof.tif", "uploaded": false, "loaded": false},
                                       {"id": "berlin-mitte.tif", "uploaded": false, "loaded": false}]})"));
    for (const std::string city : {"/berlin-adlershof.tif", "/berlin-mitte.tif"}) {
        EXPECT_EQ(get_json(maps + city)["attribution"], "(c) OpenStreetMap contributors, ODbL 1.0");
    }
    get_json(maps + "/house.map", 404);
    end();
    options_.maps = path("maps");
    put("maps/berlin-mitte.tif", "type octile\nheight 1\nwidth 1\nmap\n.\n");  // replaces it
    begin();
    EXPECT_EQ(get_json(maps + "/berlin-mitte.tif")["width"], 1);
}

TEST_F(ServiceTest, ObstaclesAreRunsOfLabels) {
    begin();
    const Json obstacles = get_json(maps + "/wall.map/obstacles");
    EXPECT_EQ(obstacles["runs"], Json::parse("[0,1,1,1,0,1]"));
    EXPECT_EQ(obstacles["obstacles"][0]["bounds"], Json::parse("[1,0,1,0]"));
    EXPECT_EQ(obstacles["obstacles"][0]["weight"], 1);
    const Json of_house = get_json(house + "/obstacles");
    int cells = 0;
    for (std::size_t i = 1; i < of_house["runs"].size(); i += 2) cells += of_house["runs"][i].get<int>();
    EXPECT_EQ(cells, 77);
    get_json(maps + "/nowhere.map/obstacles", 404);
}

TEST_F(ServiceTest, ManyObstaclesComeInParts) {
    begin();
    const std::string path = maps + "/wall.map/obstacles";
    const Json whole = get_json(path);
    EXPECT_TRUE(whole["next"].is_null());
    const std::string comb = "type octile\nheight 1\nwidth 7\nmap\n.@.@.@.\n";
    const std::string location = post(maps, comb, octets).get_header_value("Location") + "/obstacles";
    const Json first = get_json(location + "?limit=2");
    EXPECT_EQ(first["obstacles"].size(), 2U);
    EXPECT_EQ(first["runs"], Json::parse("[0,1,1,1,0,1,2,1,0,1]"));
    EXPECT_EQ(first["next"], 5);
    const Json second = get_json(location + "?limit=2&after=5");
    EXPECT_EQ(second["obstacles"][0]["id"], 3);
    EXPECT_EQ(second["runs"], Json::parse("[3,1,0,1]"));
    EXPECT_TRUE(second["next"].is_null());
    for (const char* query : {"?limit=100001", "?limit=0", "?limit=x", "?after=-1", "?after=1x", "?after="}) {
        EXPECT_EQ(get_json(location + query, 400)["type"], "/problems/invalid-request") << query;
    }
}

TEST_F(ServiceTest, WhatAClientHasIsNotSentAgain) {
    begin();
    std::set<std::string> tags;
    for (const char* part : {"", "/obstacles", "/background", "/file", "/obstacles?limit=1"}) {
        const httplib::Response answer = get(house + part);
        const std::string tag = answer.get_header_value("ETag");
        EXPECT_TRUE(tag.starts_with("W/\"") && tags.insert(tag).second) << tag;
        EXPECT_EQ(answer.get_header_value("Cache-Control"), "private, no-cache");
        const httplib::Response again = get(house + part, {{"If-None-Match", tag}});
        EXPECT_EQ(again.status, 304) << part;
        EXPECT_EQ(again.get_header_value("ETag"), tag);
        EXPECT_EQ(get(house + part, {{"If-None-Match", "\"other\""}}).body, answer.body);
    }
    end();
    put("maps/house.map", "type octile\nheight 1\nwidth 1\nmap\n.\n");
    begin();
    for (const std::string& tag : tags) EXPECT_EQ(get(house, {{"If-None-Match", tag}}).status, 200);
}

TEST_F(ServiceTest, ATimeLimitIsThatOfTheWholeRequest) {
    constexpr int side = 300;
    put("maps/thicket.map", thicket(side));
    begin();
    Json request = long_mission(side);
    request["options"]["time_limit"] = 0.5;
    for (int i = 0; i < 8; ++i)
        request["methods"].push_back({{"name", std::to_string(i)}, {"options", Json::object()}});
    double seconds = 0;
    const Json answer = post_json(maps + "/thicket.map/compare", request);
    for (const Json& one : answer["plans"]) {
        seconds += one["plan"]["seconds"]["select"].get<double>();
    }
    EXPECT_LT(seconds, 2);  // 4, were it that of each plan
}

TEST_F(ServiceTest, PlansAndThePlanHolds) {
    begin();
    const Json plan = post_json(house + "/plan", house_mission);
    EXPECT_EQ(plan["status"], "solved");
    EXPECT_EQ(plan["removed"][0]["obstacle"], 1);
    EXPECT_LT(plan["after"]["makespan"], plan["before"]["makespan"]);
    EXPECT_EQ(post_json(house + "/check", plan)["valid"], true);
    Json wrong = plan;
    wrong["after"]["makespan"] = 1;
    EXPECT_EQ(post_json(house + "/check", wrong)["valid"], false);
    EXPECT_EQ(post_json(maps + "/wall.map/check", plan)["valid"], false);
}

TEST_F(ServiceTest, ExplainsOptionsAndMethods) {
    begin();
    Json request = house_mission;
    request["options"].update({{"explain", true}, {"objective", "flowtime"}, {"weights", "cells"}, {"budget", 10}});
    request["no_timing"] = true;
    const Json plan = post_json(house + "/plan", request);
    EXPECT_TRUE(plan["removed"][0].contains("saves"));
    EXPECT_EQ(plan["removed"][0]["weight"], 6);
    EXPECT_FALSE(plan.contains("seconds"));
    request["options"]["budget"] = 5;
    EXPECT_TRUE(post_json(house + "/plan", request)["removed"].empty());
    request = house_mission;
    request["options"]["protect"] = {1};
    EXPECT_TRUE(post_json(house + "/plan", request)["removed"].empty());

    const Json usual = post_json(house + "/compare", house_mission);
    ASSERT_EQ(usual["plans"].size(), 3U);
    EXPECT_EQ(usual["plans"][0]["plan"]["removed"].size(), 0U);
    EXPECT_EQ(usual["plans"][1]["plan"]["options"]["planner"], "theta");
    EXPECT_EQ(usual["plans"][2]["plan"]["options"]["select"], "exact");
    request = house_mission;
    request["methods"] = Json::parse(R"([{"name": "jumps", "options": {"planner": "jps", "select": "hits"}}])");
    EXPECT_EQ(post_json(house + "/compare", request)["plans"][0]["plan"]["options"]["planner"], "jps");

    const Json front = post_json(house + "/front", house_mission)["front"];
    ASSERT_EQ(front.size(), 2U);
    EXPECT_LT(front[1]["makespan"], front[0]["makespan"]);
}

TEST_F(ServiceTest, NoPlanIsAnAnswer) {
    begin();
    const Json request = Json::parse(R"({"mission": {"start": [0, 0], "goal": [2, 0]}, "options": {"removals": 0}})");
    EXPECT_EQ(post_json(maps + "/wall.map/plan", request)["status"], "no_plan");
}

TEST_F(ServiceTest, ExportsWhatIsValid) {
    begin();
    const Json plan = post_json(house + "/plan", house_mission);
    for (const std::string format : {"json", "csv", "ros-path", "xml", "svg", "png", "html", "reach"}) {
        const auto answer = post(house + "/export?format=" + format, plan.dump());
        EXPECT_EQ(answer.status, 200) << format << answer.body;
        EXPECT_FALSE(answer.body.empty());
    }
    // The ways are drawn, in their colours.
    const std::string picture = post(house + "/export?format=svg", plan.dump()).body;
    EXPECT_NE(picture.find("ground path</text>"), std::string::npos);
    const auto page = post(house + "/export?format=html", plan.dump());
    EXPECT_EQ(page.get_header_value("Content-Type"), "text/html; charset=utf-8");
    EXPECT_NE(page.get_header_value("Content-Security-Policy").find("default-src 'none'"), std::string::npos);
    EXPECT_NE(page.body.find("id=\"waybreaker\""), std::string::npos);
    EXPECT_NE(page.body.find("<noscript>"), std::string::npos);
    // The map does not say where on earth it lies.
    post_json(house + "/export?format=geojson", plan, 422);
    post_json(house + "/export?format=exe", plan, 400);
    Json wrong = plan;
    wrong["after"]["makespan"] = 1;
    post_json(house + "/export?format=csv", wrong, 422);
}

TEST_F(ServiceTest, ExportsBandsOfManyPlaces) {
    begin();
    const Json mission = Json::parse(R"({"format": "waybreaker-mission/1", "agents": [
        {"id": "a", "kind": "ground", "start": [0, 0], "goal": [0, 0]},
        {"id": "b", "kind": "ground", "start": [0, 0], "goal": [2, 0]},
        {"id": "air", "kind": "air", "start": [0, 0], "goal": [0, 0]}],
        "rules": {"removals": 1, "collisions": false, "objective": "flowtime", "unreached": 50}})");
    const Json plan = post_json(maps + "/wall.map/plan", mission);
    const Json reach = post_json(maps + "/wall.map/export?format=reach", plan);
    EXPECT_EQ(reach["format"], "waybreaker-reach/1");
    EXPECT_FALSE(reach["bands"].empty());
    EXPECT_EQ(reach["gains"], Json::parse("[0, 2, 2, 1]"));  // behind the wall, only now
    const Json other = post_json(house + "/plan", house_mission);
    EXPECT_EQ(post_json(house + "/export?format=reach", other)["bands"], Json::array());
}

TEST_F(ServiceTest, KeepsUploadsInMemory) {
    options_.limits.maps = 2;
    begin();
    const std::string wall = "type octile\nheight 1\nwidth 4\nmap\n.@..\n";
    const auto first = post(maps, wall, octets);
    EXPECT_EQ(first.status, 201);
    const std::string location = first.get_header_value("Location");
    EXPECT_EQ(get_json(location)["width"], 4);
    EXPECT_EQ(post(maps, wall, octets).status, 200);
    EXPECT_EQ(post(maps + "?connectivity=8", wall, octets).status, 201);
    EXPECT_EQ(post(maps + "?connectivity=6", wall, octets).status, 400);
    // Evicts the least recently used.
    EXPECT_EQ(post(maps, "type octile\nheight 1\nwidth 1\nmap\n.\n", octets).status, 201);
    get_json(location, 404);
    EXPECT_EQ(file_count(), 1);  // the maps folder: nothing was written
}

TEST_F(ServiceTest, GivesTheFileThatItRead) {
    begin();
    const httplib::Response file = get(house + "/file");
    EXPECT_EQ(file.body, bytes_of("maps/house.map"));
    EXPECT_EQ(file.get_header_value("Content-Disposition"), "attachment; filename=\"house.map\"");
    const std::string wall = "type octile\nheight 1\nwidth 4\nmap\n.@..\n";
    const std::string location = post(maps, wall, octets).get_header_value("Location");
    EXPECT_EQ(get(location + "/file").body, wall);
    EXPECT_TRUE(get(location + "/file").get_header_value("Content-Disposition").ends_with(".map\""));
    put("maps/robot.pgm", "P2 1 1 255 255\n");
    put("maps/robot.yaml",
        "image: robot.pgm\nresolution: 1\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n");
    EXPECT_EQ(get(maps + "/robot.yaml").status, 200);
    EXPECT_EQ(get(maps + "/robot.yaml/file").status, 422);
}

TEST_F(ServiceTest, DeletesUploadsAndNothingElse) {
    begin();
    const std::string location =
        post(maps, "type octile\nheight 1\nwidth 2\nmap\n.@\n", octets).get_header_value("Location");
    EXPECT_EQ(remove(location).status, 204);
    EXPECT_EQ(get(location).status, 404);
    EXPECT_EQ(remove(location).status, 404);
    EXPECT_EQ(remove(house).status, 403);
    EXPECT_EQ(remove(maps + "/berlin-mitte.tif").status, 403);
    EXPECT_EQ(get(house).status, 200);
}

TEST_F(ServiceTest, LongResponsesAreCompressed) {
    begin();
    for (const char* part : {"/obstacles", "/background"}) {
        const std::string path = maps + "/berlin-mitte.tif" + part;
        const httplib::Response plain = get(path);
        EXPECT_FALSE(plain.has_header("Content-Encoding"));
        EXPECT_EQ(plain.get_header_value("Vary"), "Accept-Encoding");
        if (plain.body.size() < 1400) continue;
        const httplib::Response packed = get(path, {{"Accept-Encoding", "gzip"}});
        EXPECT_EQ(packed.get_header_value("Content-Encoding"), "gzip") << path;
        EXPECT_EQ(packed.body, plain.body);  // the client has decompressed it
    }
    EXPECT_FALSE(get(house, {{"Accept-Encoding", "gzip, br"}}).has_header("Content-Encoding"));
}

TEST_F(ServiceTest, StopsHoweverEarlyItIsAsked) {
    for (int i = 0; i < 5; ++i) {
        begin();
        end();
    }
    EXPECT_EQ(log().back()["event"], "stopped");
}

TEST_F(ServiceTest, ServesMetricsAndLogs) {
    begin();
    EXPECT_EQ(get_json("/healthz"), Json::parse(R"({"status": "ok"})"));
    EXPECT_EQ(get_json("/api/v1/openapi.json"), Json::parse(openapi_json()));
    post_json(house + "/plan", house_mission);
    const std::string text = get("/metrics").body;
    EXPECT_NE(
        text.find("waybreaker_requests_total{method=\"POST\",route=\"/api/v1/maps/{id}/plan\",status=\"200\"} 1\n"),
        std::string::npos);
    EXPECT_NE(text.find("waybreaker_plan_seconds_count 1\n"), std::string::npos);
    EXPECT_NE(text.find("waybreaker_maps_loaded 1\n"), std::string::npos);
    const std::vector<Json> lines = log();
    const auto of_plan = std::find_if(lines.begin(), lines.end(),
                                      [](const Json& line) { return line.value("path", "") == house + "/plan"; });
    ASSERT_NE(of_plan, lines.end());
    EXPECT_EQ((*of_plan)["status"], 200);
    EXPECT_EQ((*of_plan)["client"], "127.0.0.1");
}

TEST_F(ServiceTest, SaysWhatIsWrongWithARequest) {
    begin();
    for (const std::string route : {"plan", "front", "compare"}) {
        const std::string path = house + "/" + route;
        post_json(path, "not an object", 400);
        post_json(path, Json::parse(R"({"options": {"removal": 1}})"), 400);
        post_json(path, Json::parse(R"({"mission": {"start": [1], "goal": [2, 2]}})"), 400);
        EXPECT_NE(post_json(path, Json::object(), 422)["detail"].get<std::string>().find("mission.start is missing"),
                  std::string::npos);
        post_json(path, Json::parse(R"({"mission": {"start": [5, 0], "goal": [0, 0]}})"), 422);
        post_json(maps + "/nowhere.map/" + route, house_mission, 404);
        EXPECT_EQ(post(path, house_mission.dump(), "text/plain").status, 415);
    }
    post_json(house + "/check", Json::object(), 400);
    EXPECT_EQ(post(house + "/check", "{}", "text/plain").status, 415);
    post_json(maps + "/nowhere.map/check", Json::object(), 404);
    post_json(house + "/export?format=csv", Json::object(), 400);
    post_json(maps + "/nowhere.map/export?format=csv", Json::object(), 404);
    EXPECT_EQ(post(house + "/export?format=csv", "{}", "text/plain").status, 415);
    const auto refused = post(maps, "map", "text/plain");
    EXPECT_EQ(refused.status, 415);
    EXPECT_EQ(refused.get_header_value("Accept-Encoding"), "gzip");
    EXPECT_EQ(get("/api/v1/nothing").status, 404);
}

}  // namespace
}  // namespace waybreaker::service
