// The description and the service are of one mind: every answer that openapi.json lists is given here, and LiveServer
// holds each against its schema.
#include <algorithm>

#include "live_server.hpp"
#include "occupation.hpp"

namespace waybreaker::server {
namespace {

class DescriptionTest : public LiveServer {
  protected:
    // Asks a route in the way that its status comes of.
    void provoke(const std::string& method, const std::string& path);
    void provoke_post(const std::string& path);
};

const std::string maps = "/api/v1/maps";
const std::string bytes = "application/octet-stream";
constexpr int side = 300;

std::string with_id(std::string path, const std::string& id) {
    const std::size_t place = path.find("{id}");
    return place == std::string::npos ? path : path.replace(place, 4, id);
}

void DescriptionTest::provoke_post(const std::string& path) {
    const std::string query = path.ends_with("/export") ? "?format=csv" : "";
    const std::string here = with_id(path, "house.map") + query;
    const std::string type = path == maps ? bytes : "application/json";
    post(here, "{}", "text/plain");                                    // 415
    post(here, std::string(5000, ' '), type);                          // 413
    post(path == maps ? maps + "?connectivity=5" : here, "[]", type);  // 400
    post(with_id(path, "nowhere.map") + query, "{}", type);            // 404
    post(with_id(path, "broken.map") + query, "{}", type);             // 422
}

void DescriptionTest::provoke(const std::string& method, const std::string& path) {
    if (method == "post") return provoke_post(path);
    for (const char* id : {"house.map", "nowhere.map", "broken.map"}) get(with_id(path, id));
}

TEST_F(DescriptionTest, EveryAnswerOfItIsGiven) {
    const Json paths = Json::parse(openapi_json())["paths"];
    std::set<std::string> described;
    put("maps/broken.map", "type octile\nheight 2\nwidth 2\nmap\n.\n");
    put("maps/thicket.map", thicket(side));
    options_.limits.upload_bytes = 4000;
    options_.limits.workers = 1;
    options_.limits.queue = 0;
    options_.limits.seconds = 60;
    begin();
    for (const auto& [path, item] : paths.items()) {
        for (const auto& [method, operation] : item.items()) {
            if (method == "parameters") continue;
            for (const auto& [status, answer] : operation["responses"].items()) {
                described.insert(method + ' ' + path + ' ' + status);
            }
            provoke(method, path);
        }
    }
    const std::string house = maps + "/house.map";
    for (const char* route : {"/front", "/compare", "/plan"}) post_json(house + route, house_mission);
    const Json plan = post_json(house + "/plan", house_mission);
    post_json(house + "/check", plan);
    post_json(house + "/export?format=json", plan);
    const std::string wall = "type octile\nheight 1\nwidth 2\nmap\n.@\n";
    post(maps, wall, bytes);
    post(maps, wall, bytes);
    {
        const Occupation busy(client(), maps + "/thicket.map/plan", long_mission(side));
        for (const char* route : {"/front", "/compare", "/plan"}) post_json(house + route, house_mission, 503);
        post_json(house + "/check", plan, 503);
        post_json(house + "/export?format=json", plan, 503);
    }
    end();
    options_.token = "secret";
    begin();
    for (const auto& [path, item] : paths.items()) provoke(item.contains("post") ? "post" : "get", path);
    for (const auto& [path, item] : paths.items()) provoke("get", item.contains("get") ? path : maps);

    std::set<std::string> missing;
    std::set_difference(described.begin(), described.end(), seen().begin(), seen().end(),
                        std::inserter(missing, missing.begin()));
    for (const std::string& answer : missing) ADD_FAILURE() << "never given: " << answer;
}

}  // namespace
}  // namespace waybreaker::server
