// The store of live missions: what it keeps over restarts, and which files it refuses.
#include "service/mission_store.hpp"

#include <SQLiteCpp/SQLiteCpp.h>

#include <fstream>

#include "input_error.hpp"
#include "live_mission.hpp"

namespace waybreaker::service {
namespace {

class MissionStoreTest : public LiveMissionServer {
  protected:
    std::string file() const { return path("missions.db"); }
    std::string refusal() const {
        return input_error([this] { MissionStore store(file()); });
    }
};

TEST_F(MissionStoreTest, ARestartLosesNothing) {
    options_.store = file();
    begin();
    const std::string sent = "type octile\nheight 2\nwidth 3\nmap\n.@.\n...\n";
    const std::string id = Json::parse(post(maps, sent, octets).body)["id"];
    Json request = rover_mission;
    request["map"] = id;
    request["agents"][0].update({{"start", {0, 0}}, {"goal", {2, 0}}});
    const std::string on_sent = begun(request);
    const std::string path = begun();
    const std::string gone = begun();
    const std::string first = post(path + "/reports", state(1, 1).dump()).body;
    post_json(path + "/reports", state(2, 1.5, gap_blocked));
    remove(gone);
    const Json list = get_json(missions);
    const std::string plan = get(path + "/plan").body;
    end();

    begin();
    EXPECT_EQ(get_json(missions), list);
    EXPECT_EQ(get(path + "/plan").body, plan);
    EXPECT_EQ(post(path + "/reports", state(1, 1).dump()).body, first);
    EXPECT_EQ(post_json(path + "/reports", state(3, 2))["status"], "no_plan");  // the gap is blocked still
    get_json(gone, 404);
    EXPECT_EQ(get_json(maps + "/" + id)["width"], 3);
    EXPECT_EQ(post_json(on_sent + "/reports", state(1, 1))["revision"], 1);
    const Json entry{{"id", id}, {"uploaded", true}, {"loaded", true}};
    const Json all = get_json(maps)["maps"];
    EXPECT_NE(std::find(all.begin(), all.end(), entry), all.end()) << all;
}

TEST_F(MissionStoreTest, WithoutOneARestartLosesAll) {
    begin();
    const std::string path = begun();
    end();
    begin();
    get_json(path, 404);
}

TEST_F(MissionStoreTest, TheLastMissionTakesItsMapWithIt) {
    MissionStore store(file());
    const ArchivedMap map{"upload-1", Connectivity::four, "map"};
    const ReportRecord first{.status = "planned", .plan = "{}", .event = "{}"};
    store.add({.id = "one", .map = "upload-1", .archive = "upload-1"}, map, first);
    store.add({.id = "two", .map = "city.tif", .archive = "upload-1"}, map, first);
    EXPECT_EQ(store.sent(), std::vector<std::string>{"upload-1"});
    store.remove("one");
    EXPECT_TRUE(store.holds("upload-1"));
    EXPECT_TRUE(store.sent().empty());
    EXPECT_EQ(store.read("upload-1")->bytes, "map");
    store.remove("two");
    EXPECT_FALSE(store.holds("upload-1"));
    EXPECT_FALSE(store.read("upload-1"));
    EXPECT_FALSE(store.report("two", 0));
}

TEST_F(MissionStoreTest, NoRevisionIsMadeTwice) {
    MissionStore store(file());
    const ReportRecord first{.status = "planned", .plan = "{}", .event = "{}"};
    store.add({.id = "one", .map = "a.map", .archive = "upload-1"}, {"upload-1", Connectivity::four, "map"}, first);
    ReportRecord report = first;
    report.sequence = 1;
    EXPECT_THROW(store.add("one", report), std::exception);  // revision 0 again
    report.revision = 1;
    store.add("one", report);
    EXPECT_THROW(store.add("one", report), std::exception);
    EXPECT_THROW(store.add("none", report), std::exception);
    EXPECT_EQ(store.reports_after("one", 0).size(), 1U);
}

TEST_F(MissionStoreTest, RefusesOtherFiles) {
    put("missions.db", "a text, and a rather long one: no database begins like that, whatever its size may be.....");
    EXPECT_NE(refusal().find("is no store of missions"), std::string::npos) << refusal();
    std::filesystem::remove(file());
    SQLite::Database(file(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE).exec("CREATE TABLE a (b)");
    EXPECT_NE(refusal().find("is a database of something else"), std::string::npos) << refusal();
    std::filesystem::remove(file());
    { MissionStore store(file()); }
    SQLite::Database(file(), SQLite::OPEN_READWRITE).exec("PRAGMA user_version = 99");
    EXPECT_NE(refusal().find("another version"), std::string::npos) << refusal();
    EXPECT_NE(input_error([this] { MissionStore store(path("maps")); }).find("is a folder"), std::string::npos);
    EXPECT_NE(input_error([this] { MissionStore store(path("none/missions.db")); }).find("cannot use"),
              std::string::npos);
}

TEST_F(MissionStoreTest, RefusesDamagedFiles) {
    {
        MissionStore store(file());
        const ReportRecord first{.status = "planned", .plan = std::string(100'000, 'x'), .event = "{}"};
        store.add({.id = "one", .map = "a.map", .archive = "upload-1"}, {"upload-1", Connectivity::four, "map"}, first);
    }
    std::fstream bytes(file(), std::ios::in | std::ios::out | std::ios::binary);
    bytes.seekp(4096);
    bytes << std::string(16384, '\x7f');
    bytes.close();
    EXPECT_NE(refusal().find("is damaged"), std::string::npos) << refusal();
}

TEST_F(MissionStoreTest, IsForOneServerAtATime) {
    MissionStore store(file());
    EXPECT_NE(refusal().find("is in use by another server"), std::string::npos) << refusal();
}

}  // namespace
}  // namespace waybreaker::service
