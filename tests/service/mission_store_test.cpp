// The store of live missions: what it keeps over restarts, and which files it refuses. scripts/with-postgres runs all
// but the latter on a database as well.
#include "service/mission_store.hpp"

#include <SQLiteCpp/SQLiteCpp.h>

#include <atomic>
#include <fstream>
#include <thread>

#include "http/problem.hpp"
#include "input_error.hpp"
#include "live_mission.hpp"
#include "service/sqlite_store.hpp"

namespace waybreaker::service {
namespace {

class MissionStoreTest : public LiveMissionServer {
  protected:
    std::unique_ptr<MissionStore> open() const { return open_store(new_store(), options_.limits, options_.log); }
};

TEST_F(MissionStoreTest, ARestartLosesNothing) {
    options_.store = new_store();
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
    options_.store = "";
    begin();
    const std::string path = begun();
    end();
    begin();
    get_json(path, 404);
}

TEST_F(MissionStoreTest, TheLastMissionTakesItsMapWithIt) {
    const auto store = open();
    EXPECT_TRUE(
        store->add({.id = "one", .map = "upload-1", .archive = "upload-1"}, archived_map, first_report, many_missions));
    EXPECT_TRUE(
        store->add({.id = "two", .map = "city.tif", .archive = "upload-1"}, archived_map, first_report, many_missions));
    EXPECT_EQ(store->sent(), std::vector<std::string>{"upload-1"});
    EXPECT_TRUE(store->remove("one"));
    EXPECT_TRUE(store->holds("upload-1"));
    EXPECT_FALSE(store->forget("upload-1"));
    EXPECT_TRUE(store->sent().empty());
    EXPECT_EQ(store->read("upload-1")->bytes, archived_map.bytes);
    EXPECT_TRUE(store->remove("two"));
    EXPECT_FALSE(store->remove("two"));
    EXPECT_FALSE(store->holds("upload-1"));
    EXPECT_TRUE(store->forget("upload-1"));
    EXPECT_FALSE(store->read("upload-1"));
    EXPECT_FALSE(store->report("two", 0));
}

TEST_F(MissionStoreTest, NoRevisionIsMadeTwice) {
    const auto store = open();
    store->add({.id = "one", .map = "a.map", .archive = "upload-1"}, archived_map, first_report, many_missions);
    ReportRecord report = first_report;
    report.sequence = 1;
    EXPECT_THROW(store->turn("one")->add(report), http::Problem);  // revision 0 again
    report.revision = 1;
    EXPECT_TRUE(store->turn("one")->add(report));
    EXPECT_THROW(store->turn("one")->add(report), http::Problem);
    EXPECT_FALSE(store->turn("none")->add(report));
    EXPECT_EQ(store->reports_after("one", 0).size(), 1U);
}

TEST_F(MissionStoreTest, GivesBackWhatItWasGiven) {
    const auto store = open();
    const MissionRecord mission{"one", "a.map", "upload-1", "sha256:1", "{\"map\": \"a.map\"}\n"};
    store->add(mission, archived_map, first_report, many_missions);
    const ReportRecord report{.sequence = std::uint64_t{1} << 62U,
                              .revision = 0,
                              .now = 1.0 / 3,
                              .status = "no_plan",
                              .state = "{\"name\": \"\\u0000 \u00e9\"}",
                              .event = "'quoted' \\ $1"};
    store->turn("one")->add(report);
    const std::optional<MissionSummary> found = store->mission("one");
    ASSERT_TRUE(found);
    EXPECT_EQ(found->mission.request, mission.request);
    EXPECT_EQ(found->mission.digest, mission.digest);
    EXPECT_EQ(found->sequence, report.sequence);
    EXPECT_EQ(found->now, report.now);
    const std::vector<MissionSummary> all = store->missions();
    ASSERT_EQ(all.size(), 1U);
    EXPECT_EQ(all[0].mission.archive, "upload-1");
    EXPECT_EQ(all[0].status, "no_plan");
    const std::optional<ReportRecord> same = store->report("one", report.sequence);
    ASSERT_TRUE(same);
    EXPECT_EQ(same->state, report.state);
    EXPECT_EQ(same->event, report.event);
    EXPECT_EQ(same->plan, "");
    EXPECT_EQ(store->planned("one", 0)->sequence, 0U);
    EXPECT_FALSE(store->planned("one", 1));
    EXPECT_FALSE(store->mission("two"));
}

TEST_F(MissionStoreTest, TakesNoMoreThanMayBeAndNoOtherMapOfAnId) {
    const auto store = open();
    EXPECT_TRUE(store->add({.id = "one", .map = "a.map", .archive = "upload-1"}, archived_map, first_report, 1));
    EXPECT_FALSE(store->add({.id = "two", .map = "a.map", .archive = "upload-1"}, archived_map, first_report, 1));
    EXPECT_THROW(store->add({.id = "two", .map = "a.map", .archive = "upload-1"}, {"upload-1", Connectivity::four, "b"},
                            first_report, many_missions),
                 http::Problem);
    EXPECT_EQ(store->count(), 1U);
}

// Each adds the next revision, which fails unless the one before is there.
TEST_F(MissionStoreTest, TurnsAreTakenOneAfterTheOther) {
    const auto store = open();
    store->add({.id = "one", .map = "a.map", .archive = "upload-1"}, archived_map, first_report, many_missions);
    std::vector<std::thread> revisers;
    std::atomic<int> failed = 0;
    for (int reviser = 0; reviser < 4; ++reviser) {
        revisers.emplace_back([&] {
            for (int i = 0; i < 10; ++i) {
                const auto turn = store->turn("one");
                ReportRecord next = first_report;
                next.sequence = store->mission("one")->sequence + 1;
                next.revision = int(next.sequence);
                std::this_thread::yield();
                try {
                    turn->add(next);
                } catch (const http::Problem&) {
                    ++failed;
                }
            }
        });
    }
    for (std::thread& reviser : revisers) reviser.join();
    EXPECT_EQ(failed, 0);
    EXPECT_EQ(store->mission("one")->revision, 40);
}

class SqliteStoreTest : public TemporaryFolder {
  protected:
    std::string file() const { return path("missions.db"); }
    std::string refusal() const {
        return input_error([this] { open_sqlite_store(file()); });
    }
};

TEST_F(SqliteStoreTest, RefusesOtherFiles) {
    put("missions.db", "a text, and a rather long one: no database begins like that, whatever its size may be.....");
    EXPECT_NE(refusal().find("is no store of missions"), std::string::npos) << refusal();
    std::filesystem::remove(file());
    SQLite::Database(file(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE).exec("CREATE TABLE a (b)");
    EXPECT_NE(refusal().find("is a database of something else"), std::string::npos) << refusal();
    std::filesystem::remove(file());
    open_sqlite_store(file());
    SQLite::Database(file(), SQLite::OPEN_READWRITE).exec("PRAGMA user_version = 99");
    EXPECT_NE(refusal().find("another version"), std::string::npos) << refusal();
    EXPECT_NE(input_error([this] { open_sqlite_store(path("")); }).find("is a folder"), std::string::npos);
    EXPECT_NE(input_error([this] { open_sqlite_store(path("none/missions.db")); }).find("cannot use"),
              std::string::npos);
}

TEST_F(SqliteStoreTest, RefusesDamagedFiles) {
    ReportRecord large = first_report;
    large.plan = std::string(100'000, 'x');
    open_sqlite_store(file())->add({.id = "one", .map = "a.map", .archive = "upload-1"}, archived_map, large,
                                   many_missions);
    std::fstream bytes(file(), std::ios::in | std::ios::out | std::ios::binary);
    bytes.seekp(4096);
    bytes << std::string(16384, '\x7f');
    bytes.close();
    EXPECT_NE(refusal().find("is damaged"), std::string::npos) << refusal();
}

TEST_F(SqliteStoreTest, IsForOneServerAtATime) {
    const auto store = open_sqlite_store(file());
    EXPECT_NE(refusal().find("is in use by another server"), std::string::npos) << refusal();
}

}  // namespace
}  // namespace waybreaker::service
