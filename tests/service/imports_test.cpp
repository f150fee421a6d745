// Map data that is sent, and maps that are imported from it.
#include <sys/stat.h>

#include <atomic>
#include <fstream>
#include <thread>

#include "city/city_import.hpp"
#include "http/problem.hpp"
#include "live_server.hpp"
#include "osm_yard.hpp"
#include "service/extract_json.hpp"
#include "service/import_worker.hpp"
#include "service/importer.hpp"
#include "service/source_store.hpp"

namespace waybreaker::service {
namespace {

class ImportsTest : public LiveServer {
  protected:
    std::string sent(const std::string& name = "yard.osm", const std::string& data = osm_yard()) const {
        return Json::parse(post(sources + "?name=" + name, data, octets).body).at("id").get<std::string>();
    }
    std::string type_of(const Json& request, int status) const {
        return post_json(imports, request, status)["type"].get<std::string>();
    }
    std::string detail_of(const Json& request, int status = 400) const {
        return post_json(imports, request, status)["detail"].get<std::string>();
    }
};

TEST_F(ImportsTest, MapDataIsDescribed) {
    begin();
    const httplib::Response first = post(sources + "?name=yard.osm", osm_yard(), octets);
    EXPECT_EQ(first.status, 201);
    const Json source = Json::parse(first.body);
    EXPECT_EQ(first.get_header_value("Location"), sources + "/" + source["id"].get<std::string>());
    EXPECT_EQ(source["name"], "yard.osm");
    EXPECT_EQ(source["buildings"], 2);
    EXPECT_EQ(source["bytes"], osm_yard().size());
    EXPECT_EQ(post(sources + "?name=yard.osm", osm_yard(), octets).status, 200);
    EXPECT_EQ(get_json(first.get_header_value("Location")), source);
    EXPECT_NE(sent("other.osm"), source["id"].get<std::string>());
    EXPECT_EQ(get_json(maps)["maps"].size(), 4U);  // no map is made of it yet
}

TEST_F(ImportsTest, MakesTheMapThatTheCommandMakes) {
    begin();
    const Json request{{"source", sent()}, {"center", {9, 50}}, {"size", 100}, {"cell", 2}, {"section", 10}};
    const Json map = post_json(imports, request, 201);
    const std::string file = get("/api/v1/maps/" + map["id"].get<std::string>() + "/file").body;
    const std::string source = put("yard.osm", osm_yard());
    const city::ImportReport report =
        city::import_city(source, {.longitude = 9, .latitude = 50, .size = 100, .cell = 2, .section = 10});
    EXPECT_EQ(file, geotiff::label_tiff_bytes(report.tiff));
    EXPECT_EQ(map["width"], 50);
    EXPECT_GT(map["obstacles"]["sections"], 2);
    EXPECT_EQ(map["title"], "yard, 100 m around 9.0000, 50.0000");
    EXPECT_EQ(post_json(imports, request, 200)["id"], map["id"]);
    // It is planned on like any other.
    const Json mission{{"mission", {{"start", {16, 16}}, {"goal", {33, 33}}}}};
    const std::string plan = "/api/v1/maps/" + map["id"].get<std::string>() + "/plan";
    EXPECT_EQ(post_json(plan, mission)["status"], "solved");
    const Json outside{{"mission", {{"start", {0, 0}}, {"goal", {33, 33}}}}};
    EXPECT_NE(post_json(plan, outside, 422)["detail"].get<std::string>().find("start 0,0 lies in unknown ground"),
              std::string::npos);
}

TEST_F(ImportsTest, OptionsAreThoseOfTheCommand) {
    begin();
    const Json whole = post_json(imports, {{"source", sent()}, {"cell", 1}, {"section", "none"}}, 201);
    EXPECT_FALSE(whole["obstacles"].contains("sections"));
    EXPECT_EQ(whole["obstacles"]["tags"]["building=yes"], 1);
    const Json paper = post_json(imports, {{"source", sent()}, {"cell", 1}, {"profile", "paper"}}, 201);
    EXPECT_TRUE(paper["ground"].is_null());
    const Json box =
        post_json(imports, {{"source", sent()}, {"bbox", {8.9995, 49.9995, 9.0005, 50.0005}}, {"names", false}}, 201);
    EXPECT_EQ(box["obstacles"]["named"], 0);
    const Json chosen = post_json(imports,
                                  {{"source", sent()},
                                   {"cell", 1},
                                   {"obstacles", "building=church"},
                                   {"obstacle_weight", "area"},
                                   {"merge_touching", true},
                                   {"background", false}},
                                  201);
    EXPECT_EQ(chosen["obstacles"]["count"], 1);
}

TEST_F(ImportsTest, ObstaclesSayWhatTheyAre) {
    begin();
    const Json map = post_json(imports, {{"source", sent()}, {"cell", 1}, {"section", "none"}}, 201);
    const Json all = get_json("/api/v1/maps/" + map["id"].get<std::string>() + "/obstacles")["obstacles"];
    const auto church = std::find_if(all.begin(), all.end(), [](const Json& one) { return one["name"] == "Dom"; });
    ASSERT_NE(church, all.end());
    EXPECT_EQ((*church)["kind"], "building");
    EXPECT_EQ((*church)["tags"], Json({"building=church"}));
    EXPECT_FALSE((*church)["destructible"]);
}

TEST_F(ImportsTest, SaysWhatTheSourceLacks) {
    begin();
    Json request{{"source", sent()}, {"center", {9.0004, 50}}, {"size", 100}};
    const Json map = post_json(imports, request, 201);
    EXPECT_EQ(map["notes"], Json::array());
    EXPECT_GT(map["unknown"], 1000);
    EXPECT_EQ(map["ground"]["unknown"], map["unknown"]);
    request["unknown_free"] = true;
    const Json free = post_json(imports, request, 201);
    EXPECT_EQ(free["unknown"], 0);
    ASSERT_EQ(free["notes"].size(), 1U);
    EXPECT_NE(free["notes"][0].get<std::string>().find("covers only"), std::string::npos);
    // They are the map's own, wherever its file goes, and whatever is drawn on it.
    const std::string file = get(maps + "/" + free["id"].get<std::string>() + "/file").body;
    EXPECT_EQ(Json::parse(post(maps, file, octets).body)["notes"], free["notes"]);
    const Json edits{{"block", {{0, 0, 3}}}};
    EXPECT_EQ(post_json(maps + "/" + free["id"].get<std::string>() + "/edits", edits, 201)["notes"], free["notes"]);
}

TEST_F(ImportsTest, SaysWhatIsWrongWithARequest) {
    begin();
    const std::string id = sent();
    EXPECT_EQ(type_of({{"source", "source-0"}}, 404), "/problems/source-not-found");
    EXPECT_EQ(detail_of(Json::object()), "import:1:1: the document has no member source");
    EXPECT_NE(detail_of({{"source", id}, {"cells", 2}}).find("a member 'cells', which is none of source, center"),
              std::string::npos);
    EXPECT_NE(detail_of({{"source", id}, {"profile", "tank"}}).find("rover, truck, walker, paper"), std::string::npos);
    EXPECT_NE(detail_of({{"source", id}, {"center", {9}}}).find("[longitude, latitude]"), std::string::npos);
    EXPECT_NE(detail_of({{"source", id}, {"center", {9, 50}}, {"bbox", {8, 49, 9, 50}}}).find("one of them"),
              std::string::npos);
    EXPECT_NE(detail_of({{"source", id}, {"obstacles", "=x"}}).find("obstacles"), std::string::npos);
    EXPECT_NE(detail_of({{"source", id}, {"section", -1}}).find("section"), std::string::npos);
    EXPECT_NE(detail_of({{"source", id}, {"size", 0}}).find("size"), std::string::npos);
    // Not the paths of the server, nor options of the command.
    const std::string far = detail_of({{"source", id}, {"center", {0, 0}}}, 422);
    EXPECT_EQ(far.find("yard.osm: has no building in the window"), 0U) << far;
    EXPECT_EQ(detail_of({{"source", id}, {"cell", 0.001}}, 422).find("cell 0.001: expected"), 0U);
    EXPECT_EQ(type_of({{"source", id}, {"protected", "amenity=zoo"}}, 422), "/problems/import-unfit");
    EXPECT_EQ(post(sources + "?name=../secret", osm_yard(), octets).status, 400);
}

TEST_F(ImportsTest, NamesFilesAndOptionsAsTheClientDoes) {
    begin();
    const std::string id = sent("a--b.osm");
    EXPECT_EQ(detail_of({{"source", id}, {"center", {0, 0}}}, 422).find("a--b.osm: has no building"), 0U);
    const std::string weight = detail_of({{"source", id}, {"obstacle_weight", "levels"}}, 422);
    EXPECT_EQ(weight.find("obstacle_weight 'levels': no obstacle of a--b.osm says"), 0U) << weight;
}

TEST_F(ImportsTest, MapsStayWithinTheLimits) {
    options_.limits.map_cells = 400;
    begin();
    const std::string id = sent();
    EXPECT_EQ(type_of({{"source", id}, {"size", 100}, {"cell", 2}}, 413), "/problems/map-too-large");
    post_json(imports, {{"source", id}, {"size", 100}, {"cell", 5}}, 201);
}

TEST(SourceStore, StaysWithinAQuarterOfTheMemory) {
    const std::string yard = osm_yard();
    ServiceLimits limits;
    MemoryBudget budget(std::size_t{1} << 30);
    const Importer importer({"/proc/self/exe", import_worker_word}, limits, budget);
    SourceStore store(importer, budget);
    MemoryBudget::Share others(budget, MemoryBudget::Use::source);
    EXPECT_TRUE(others.grow(budget.most() / 4 - 2 * yard.size() - 100));  // leaves room for two
    const std::string first = store.add(yard, "first.osm", {}).id;
    const std::string second = store.add(yard, "second.osm", {}).id;
    const SharedSource used = store.find(second);
    const std::string third = store.add(yard, "third.osm", {}).id;
    EXPECT_EQ(store.find(second), used);
    EXPECT_NE(store.find(third), nullptr);
    EXPECT_THROW(store.find(first), http::Problem);
    const auto large = [&] { store.add(std::string(budget.most() / 4 + 1, ' '), "large.osm", {}); };
    EXPECT_THROW(large(), http::Problem);
    EXPECT_NE(store.find(third), nullptr);
}

TEST_F(ImportsTest, SourcesAreForgottenWhenAsked) {
    begin();
    const std::string id = sent();
    const Json map = post_json(imports, {{"source", id}, {"cell", 1}}, 201);
    EXPECT_EQ(remove(sources + "/" + id).status, 204);
    EXPECT_EQ(remove(sources + "/" + id).status, 404);
    EXPECT_EQ(type_of({{"source", id}}, 404), "/problems/source-not-found");
    get_json("/api/v1/maps/" + map["id"].get<std::string>());  // maps stay
}

// Every beginning of a source is refused or read, and the server goes on.
TEST_F(ImportsTest, SurvivesBrokenSources) {
    begin();
    const std::string yard = osm_yard();
    for (std::size_t length = 0; length < yard.size(); length += 13) {
        const int status = post(sources, yard.substr(0, length), octets).status;
        EXPECT_TRUE(status == 422 || status == 400) << length << ": " << status;
    }
    for (const std::string& data :
         {std::string("\x1f\x8b\x08\0garbage", 11), std::string("\0\0\0\x0d\n\x09OSMHeader\x18\x7f", 17),
          std::string(3000, '['), std::string(R"({"type": "FeatureCollection", "features": [)"),
          std::string(R"({"type": "FeatureCollection", "features": []})"), std::string("\0\xff\0\xff", 4),
          "<OGRVRTDataSource><OGRVRTLayer name=\"a\"><SrcDataSource>/etc/passwd</SrcDataSource></OGRVRTLayer>"
          "</OGRVRTDataSource>" +
              std::string()}) {
        const Json problem = Json::parse(post(sources, data, octets).body);
        EXPECT_EQ(problem["type"], "/problems/source-unreadable") << data;
        EXPECT_EQ(problem["detail"].get<std::string>().find("/vsi"), std::string::npos) << problem;
    }
    post_json(imports, {{"source", sent()}, {"cell", 1}}, 201);
}

// While one is read that does not end, whatever else is asked gets its answer.
TEST_F(ImportsTest, KeepNobodyWaiting) {
    const std::string gate = path("gate");
    ASSERT_EQ(mkfifo(gate.c_str(), S_IRUSR | S_IWUSR), 0);
    options_.import_worker = {"/bin/sh", "-c", "exec cat " + gate};
    options_.limits.workers = 1;
    begin();
    std::atomic<int> answered = 0;
    std::vector<std::thread> senders;
    for (const char* name : {"first.osm", "second.osm"}) {
        senders.emplace_back([this, name, &answered] {
            EXPECT_EQ(post(sources + "?name=" + name, osm_yard(), octets).status, 201);
            ++answered;
        });
    }
    while (get("/metrics").body.find("waybreaker_imports_waiting 1\n") == std::string::npos) std::this_thread::yield();
    EXPECT_EQ(post_json(maps + "/house.map/plan", house_mission)["status"], "solved");
    EXPECT_EQ(post(maps, thicket(20), octets).status, 201);
    post_json(maps + "/house.map/edits", {{"block", {{0, 0, 1}}}}, 201);
    const std::string answer = extract_json({.buildings = 1, .columns = 1, .rows = 1, .built = {1}, .side = 10}).dump();
    for (int i = 0; i < 2; ++i) {
        std::ofstream(gate) << R"({"bytes": 0, "extract": )" << answer << "}\n";
        while (answered == i) std::this_thread::yield();
    }
    for (std::thread& sender : senders) sender.join();
}

TEST_F(ImportsTest, ManyClientsImportAtATime) {
    options_.limits.workers = 4;
    begin();
    const std::string id = sent();
    std::vector<std::thread> clients;
    for (int i = 0; i < 6; ++i) {
        clients.emplace_back([this, id, i] {
            const Json request{{"source", id}, {"center", {9, 50}}, {"size", 100}, {"cell", 1 + i % 3}};
            const int status = post(imports, request.dump()).status;
            EXPECT_TRUE(status == 200 || status == 201) << status;
        });
    }
    for (std::thread& client : clients) client.join();
    EXPECT_EQ(get_json(maps)["maps"].size(), 4U + 3U);
}

}  // namespace
}  // namespace waybreaker::service
