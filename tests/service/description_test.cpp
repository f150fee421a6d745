// openapi.json and the service agree: every response that openapi.json lists is provoked here, and LiveServer checks
// each against its schema.
#include <sys/stat.h>

#include <algorithm>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <thread>

#include "live_mission.hpp"
#include "osm_yard.hpp"
#include "service/extract_json.hpp"
#include "streaming_client.hpp"
#include "wire.hpp"

namespace waybreaker::service {
namespace {

constexpr int thicket_side = 300;

std::string with_id(std::string path, const std::string& id) {
    const std::size_t place = path.find("{id}");
    return place == std::string::npos ? path : path.replace(place, 4, id);
}

std::string type_of(const std::string& path) {
    return path == maps || path == sources || path.ends_with("/overlays") ? octets : "application/json";
}

class DescriptionTest : public LiveMissionServer {
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
        const std::string query = path.ends_with("/export")     ? "?format=csv"
                                  : path.ends_with("/overlays") ? "?as=water"
                                                                : "";
        const std::string type = type_of(path);
        post(here, "{}", "text/plain");                                            // 415
        post(here, std::string(5000, ' '), type);                                  // 413
        post(path == maps ? maps + "?connectivity=5" : here + query, "[]", type);  // 400
        post(here + "?name=/", "{}", type);                                        // 400
        post(here, R"({"source": "none"})", type);                                 // 404
        post(with_id(path, "nowhere.map") + query, "{}", type);                    // 404
        post(with_id(path, "broken.map") + query, "{}", type);                     // 422
    }
    void provoke_imports() const;
    void provoke_missions() const;
    void provoke_busy(const Json& plan) const;
    void provoke_busy_imports();
    void provoke_shortage();
};

void DescriptionTest::provoke_imports() const {
    const auto send = [this] { return Json::parse(post(sources, osm_yard(), octets).body)["id"].get<std::string>(); };
    const std::string id = send();
    send();
    get_json(sources + "/" + id);
    post_json(imports, {{"source", id}}, 201);
    const std::string map = post_json(imports, {{"source", id}}, 200)["id"].get<std::string>();
    const std::string cross = R"({"type": "LineString", "coordinates": [[8.9999, 50], [9.0001, 50]]})";
    for (const int status : {201, 200}) {
        EXPECT_EQ(post(maps + "/" + map + "/overlays?as=closed", cross, octets).status, status);
    }
    post_json(imports, {{"source", id}, {"center", {0, 0}}}, 422);
    remove(sources + "/" + id);
}

void DescriptionTest::provoke_missions() const {
    const std::string other = begun();
    const std::string live = begun();
    post_json(missions, rover_mission, 507);
    remove(other);
    Json request = rover_mission;
    request["map"] = "nowhere.map";
    post_json(missions, request, 404);
    request = rover_mission;
    request["agents"][0]["goal"] = {5, 0};
    post_json(missions, request, 422);
    get_json(missions);
    get_json(live);
    get_json(live + "/plan");
    EXPECT_EQ(get(live + "/plan?revision=x").status, 400);
    EXPECT_EQ(get(live + "/events", {{"Last-Event-ID", "x"}}).status, 400);
    EXPECT_EQ(post(live + "/reports", "[]").status, 400);
    EXPECT_EQ(post(live + "/reports", state(1, 1).dump()).status, 200);
    EXPECT_EQ(post(live + "/reports", state(1, 2).dump()).status, 409);
    EXPECT_EQ(post(live + "/reports", state(2, 0).dump()).status, 422);
    std::thread listening([&] { get(live + "/events"); });
    while (get("/metrics").body.find("waybreaker_event_streams 1\n") == std::string::npos) std::this_thread::yield();
    remove(live);
    listening.join();
}

void DescriptionTest::provoke_busy(const Json& plan) const {
    const std::string house = maps + "/house.map";
    const std::string live = begun();
    const StreamingClient busy(client(), maps + "/thicket.map/plan", long_mission(thicket_side));
    post_json(live + "/reports", state(1, 1), 503);
    post_json(missions, rover_mission, 503);
    for (const char* route : {"/front", "/compare", "/plan"}) post_json(house + route, house_mission, 503);
    post_json(house + "/check", plan, 503);
    post_json(house + "/export?format=json", plan, 503);
    post_json(house + "/revise", {{"plan", plan}, {"state", state(1, 1)}}, 503);
    for (const char* route : {"", "/obstacles", "/background", "/file"}) get_json(maps + "/wall.map" + route, 503);
}

// The first source is read at once, the second until something is written to the gate.
void DescriptionTest::provoke_busy_imports() {
    const std::string gate = path("gate");
    ASSERT_EQ(mkfifo(gate.c_str(), S_IRUSR | S_IWUSR), 0);
    const city::Extract extract{.buildings = 1, .columns = 1, .rows = 1, .built = {1}, .side = 10};
    const std::string answer = R"({"bytes": 0, "extract": )" + extract_json(extract).dump() + "}\n";
    put("extract.json", answer);
    options_.import_worker = {"/bin/sh", "-c",
                              "cd " + path(".") + "; mkdir first && exec cat extract.json; exec cat gate"};
    begin();
    const std::string first = Json::parse(post(sources, osm_yard(), octets).body)["id"].get<std::string>();
    std::thread second([this] { post(sources + "?name=second", osm_yard(), octets); });
    while (get("/metrics").body.find("waybreaker_imports_running 1\n") == std::string::npos) std::this_thread::yield();
    post_json(imports, {{"source", first}}, 503);
    EXPECT_EQ(post(sources + "?name=third", osm_yard(), octets).status, 503);
    EXPECT_EQ(post(maps + "/house.map/overlays?as=closed", "{}", octets).status, 503);
    std::ofstream(gate) << answer;
    second.join();
    end();
}

// A client that has sent a large body, but not all of it, has the memory for another map.
void DescriptionTest::provoke_shortage() {
    constexpr std::size_t megabyte = std::size_t{1} << 20;
    put("maps/large.map", thicket(600));
    options_.limits.upload_bytes = 8 * megabyte;
    options_.limits.memory = 10 * megabyte;
    options_.limits.timeout = 60;
    begin();
    auto wire = std::make_unique<Wire>(port());
    wire->send(
        "POST /api/v1/maps HTTP/1.1\r\nHost: localhost\r\nContent-Type: application/octet-stream\r\nContent-Length: " +
        std::to_string(8 * megabyte) + "\r\n\r\n" + std::string(7 * megabyte, '.'));
    const std::string sent = "waybreaker_memory_bytes{use=\"requests\"} " + std::to_string(7 * megabyte);
    while (get("/metrics").body.find(sent) == std::string::npos) std::this_thread::yield();
    EXPECT_EQ(post(maps, thicket(601), octets).status, 503);
    post_json(maps + "/large.map/edits", Json::object(), 503);
    wire.reset();  // or the server would wait for the rest
    end();
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
    options_.limits.live_missions = 2;
    begin();
    for (const auto& [path, item] : paths.items()) {
        for (const auto& [method, operation] : item.items()) {
            if (method == "parameters") continue;
            for (const auto& [status, answer] : operation["responses"].items()) {
                if (answer.value("$ref", "").ends_with("/StoreUnusable")) continue;  // shared_store_test.cpp
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
    post_json(house + "/revise", {{"plan", plan}, {"state", state(1, 1)}});
    Json unfit = state(1, 1);
    unfit["agents"] = Json::parse(R"([{"id": "nobody", "passed": 0}])");
    post_json(house + "/revise", {{"plan", plan}, {"state", unfit}}, 422);
    const std::string wall = "type octile\nheight 1\nwidth 2\nmap\n.@\n";
    post(maps, wall, octets);
    post(maps, wall, octets);
    const Json edits = Json::parse(R"({"free": [[5, 0, 1]]})");
    post_json(house + "/edits", edits, 201);
    remove(maps + "/" + post_json(house + "/edits", edits)["id"].get<std::string>());
    provoke_imports();
    provoke_missions();
    provoke_busy(plan);
    end();
    provoke_busy_imports();
    provoke_shortage();
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
}  // namespace waybreaker::service
