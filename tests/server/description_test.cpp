// openapi.json and the service agree: every response that openapi.json lists is provoked here, and LiveServer checks
// each against its schema.
#include <algorithm>

#include "live_server.hpp"
#include "osm_yard.hpp"
#include "streaming_client.hpp"

namespace waybreaker::server {
namespace {

constexpr int thicket_side = 300;

std::string with_id(std::string path, const std::string& id) {
    const std::size_t place = path.find("{id}");
    return place == std::string::npos ? path : path.replace(place, 4, id);
}

std::string type_of(const std::string& path) {
    return path == maps || path == sources ? octets : "application/json";
}

class DescriptionTest : public LiveServer {
  protected:
    void ask(const std::string& method, const std::string& path, const httplib::Headers& headers = {}) const {
        if (method == "get") get(path, headers);
        if (method == "delete") remove(path, headers);
        if (method == "post") post(path, "{}", type_of(path), headers);
    }
    // Provokes every error response of a route.
    void provoke(const std::string& method, const std::string& path) const {
        for (const char* id : {"house.map", "nowhere.map", "broken.map"}) ask(method, with_id(path, id));
        const std::string here = with_id(path, "house.map");
        ask(method, here, {{"Origin", "http://evil.example"}});  // 403
        ask(method, here, {{"Host", "evil.example"}});           // 421
        ask(method, here, {{"If-None-Match", "*"}});             // 304
        ask(method, here + "?after=x");                          // 400
        if (method != "post") return;
        const std::string query = path.ends_with("/export") ? "?format=csv" : "";
        const std::string type = type_of(path);
        post(here, "{}", "text/plain");                                            // 415
        post(here, std::string(5000, ' '), type);                                  // 413
        post(path == maps ? maps + "?connectivity=5" : here + query, "[]", type);  // 400
        post(here + "?name=/", "{}", type);                                        // 400
        post(here, R"({"source": "none"})", type);                                 // 404
        post(with_id(path, "nowhere.map") + query, "{}", type);                    // 404
        post(with_id(path, "broken.map") + query, "{}", type);                     // 422
    }
    std::string provoke_imports() const;
    void provoke_busy(const Json& plan, const std::string& source) const;
};

// Gives a source that stays behind.
std::string DescriptionTest::provoke_imports() const {
    const auto send = [this] { return Json::parse(post(sources, osm_yard(), octets).body)["id"].get<std::string>(); };
    const std::string id = send();
    send();
    get_json(sources + "/" + id);
    post_json(imports, {{"source", id}}, 201);
    post_json(imports, {{"source", id}}, 200);
    post_json(imports, {{"source", id}, {"center", {0, 0}}}, 422);
    remove(sources + "/" + id);
    return send();
}

void DescriptionTest::provoke_busy(const Json& plan, const std::string& source) const {
    const std::string house = maps + "/house.map";
    const StreamingClient busy(client(), maps + "/thicket.map/plan", long_mission(thicket_side));
    for (const char* route : {"/front", "/compare", "/plan"}) post_json(house + route, house_mission, 503);
    post_json(house + "/check", plan, 503);
    post_json(house + "/export?format=json", plan, 503);
    post_json(house + "/edits", Json::object(), 503);
    post(maps, "type octile\nheight 1\nwidth 1\nmap\n.\n", octets);
    post_json(imports, {{"source", source}}, 503);
    post(sources, osm_yard(), octets);
    for (const char* route : {"", "/obstacles", "/background", "/file"}) get_json(maps + "/wall.map" + route, 503);
}

TEST_F(DescriptionTest, EveryListedResponseOccurs) {
    const Json paths = Json::parse(openapi_json())["paths"];
    std::set<std::string> described;
    put("maps/broken.map", "type octile\nheight 2\nwidth 2\nmap\n.\n");
    put("maps/thicket.map", thicket(thicket_side));
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
    get("/problems/map-not-found");
    const std::string house = maps + "/house.map";
    for (const char* route : {"/front", "/compare", "/plan"}) post_json(house + route, house_mission);
    const Json plan = post_json(house + "/plan", house_mission);
    post_json(house + "/check", plan);
    post_json(house + "/export?format=json", plan);
    const std::string wall = "type octile\nheight 1\nwidth 2\nmap\n.@\n";
    post(maps, wall, octets);
    post(maps, wall, octets);
    const Json edits = Json::parse(R"({"free": [[5, 0, 1]]})");
    post_json(house + "/edits", edits, 201);
    remove(maps + "/" + post_json(house + "/edits", edits)["id"].get<std::string>());
    provoke_busy(plan, provoke_imports());
    end();
    options_.token = "secret";
    begin();
    for (const auto& [path, item] : paths.items()) {
        for (const auto& [method, operation] : item.items()) ask(method, with_id(path, "house.map"));  // 401
    }

    std::set<std::string> missing;
    std::set_difference(described.begin(), described.end(), seen().begin(), seen().end(),
                        std::inserter(missing, missing.begin()));
    for (const std::string& answer : missing) ADD_FAILURE() << "never given: " << answer;
}

TEST_F(DescriptionTest, NoPathHasOtherMethodsThanItSays) {
    begin();
    const Json paths = Json::parse(openapi_json())["paths"];
    for (const auto& [path, item] : paths.items()) {
        const auto answer = client().Put(with_id(path, "house.map"), "{}", "application/json");
        ASSERT_TRUE(answer) << path;
        EXPECT_EQ(answer->status, 405) << path;
        const std::string allowed = answer->get_header_value("Allow");
        for (const auto& [method, word] : {std::pair("get", "GET"), {"post", "POST"}, {"delete", "DELETE"}}) {
            EXPECT_EQ(allowed.find(word) != std::string::npos, item.contains(method)) << path << ": " << allowed;
        }
    }
}

}  // namespace
}  // namespace waybreaker::server
