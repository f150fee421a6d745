// Live missions of several servers on one PostgreSQL database; scripts/with-postgres has one.
#include <algorithm>
#include <atomic>
#include <chrono>
#include <thread>

#include "http/problem.hpp"
#include "input_error.hpp"
#include "listening.hpp"
#include "live_mission.hpp"
#include "service/mission_store.hpp"

namespace waybreaker::service {
namespace {

// The server of the fixture, and a second one, that has no maps of its own.
class SharedStoreTest : public LiveMissionServer {
  protected:
    ~SharedStoreTest() override { end_other(); }

    void SetUp() override {
        if (!on_postgres()) GTEST_SKIP() << "there is no PostgreSQL: scripts/with-postgres COMMAND has one";
    }

    void begin_both() {
        begin();
        ServiceOptions options = options_;
        options.maps = "";
        options.log = [](const std::string&) {};
        other_service_ = std::make_unique<Service>(options);
        other_thread_ = std::thread([this] { other_service_->run(); });
    }
    void end_other() {
        if (!other_thread_.joinable()) return;
        other_service_->stop();
        other_thread_.join();
        other_service_.reset();
    }
    httplib::Client other() const {
        httplib::Client client("127.0.0.1", other_service_->port());
        client.set_read_timeout(60);
        return client;
    }
    std::string post_other(const std::string& path, const Json& body) const {
        return other().Post(path, body.dump(), "application/json")->body;
    }

    std::unique_ptr<MissionStore> open() const { return open_store(options_.store, options_.limits, options_.log); }
    std::string refusal(const std::string& url) const {
        return input_error([&] { open_store(url, options_.limits, options_.log); });
    }

  private:
    std::unique_ptr<Service> other_service_;
    std::thread other_thread_;
};

TEST_F(SharedStoreTest, AnyServerAnswers) {
    begin_both();
    const std::string path = begun();  // on a map that the other server has not
    EXPECT_EQ(other().Get(missions)->body, get(missions).body);
    EXPECT_EQ(other().Get(path + "/plan")->body, get(path + "/plan").body);
    const std::string answer = post_other(path + "/reports", state(1, 1));
    EXPECT_EQ(Json::parse(answer)["revision"], 1) << answer;
    EXPECT_EQ(get_json(path)["revision"], 1);
    EXPECT_EQ(post(path + "/reports", state(1, 1).dump()).body, answer);
    EXPECT_EQ(post_json(path + "/reports", state(2, 1.5, gap_blocked))["status"], "no_plan");
    EXPECT_EQ(Json::parse(post_other(path + "/reports", state(3, 2)))["status"], "no_plan");  // it is blocked still
    EXPECT_EQ(other().Delete(path)->status, 204);
    get_json(path, 404);
    EXPECT_EQ(kind(post_json(path + "/reports", state(4, 3), 404)), "/problems/mission-not-found");
}

TEST_F(SharedStoreTest, EventsComeFromAllServers) {
    begin_both();
    const std::string path = begun();
    Listening here(client(), path + "/events");
    Listening there(other(), path + "/events");
    here.await(1);
    there.await(1);
    post_other(path + "/reports", state(4, 1));
    here.await(2);
    post_json(path + "/reports", state(6, 2));
    post_other(path + "/reports", state(9, 3));
    here.await(4);
    there.await(4);
    const Listening late(other(), path + "/events", {{"Last-Event-ID", "4"}});
    EXPECT_EQ(ids_of(late.await(2)), (std::vector<std::string>{"6", "9"}));
    other().Delete(path);
    here.to_the_end();
    there.to_the_end();
    EXPECT_EQ(ids_of(here.events()), (std::vector<std::string>{"0", "4", "6", "9", ""}));
    EXPECT_EQ(here.events(), there.events());
}

TEST_F(SharedStoreTest, OneReportAtSeveralServersIsOneReport) {
    begin_both();
    const std::string path = begun();
    constexpr int reports = 10;
    for (int i = 1; i <= reports; ++i) {
        const Json report = state(i, 0.1 * i);
        std::string there;
        std::thread asking([&] { there = post_other(path + "/reports", report); });
        const std::string here = post(path + "/reports", report.dump()).body;
        asking.join();
        EXPECT_EQ(here, there);
        EXPECT_EQ(Json::parse(here)["revision"], i);
    }
    EXPECT_EQ(get_json(path)["revision"], reports);
}

TEST_F(SharedStoreTest, MapsThatWereSentAreThereForAll) {
    options_.limits.maps = 2;
    begin_both();
    const auto sent = [this](const std::string& row) {
        return Json::parse(post(maps, "type octile\nheight 1\nwidth 3\nmap\n" + row + "\n", octets).body)["id"]
            .get<std::string>();
    };
    const std::string one = sent("..@");
    EXPECT_EQ(Json::parse(other().Get(maps + "/" + one)->body)["width"], 3);
    EXPECT_NE(other().Get(maps)->body.find(one), std::string::npos);
    const std::string edited =
        Json::parse(post_other(maps + "/" + one + "/edits", {{"free", {{2, 0, 1}}}}))["id"].get<std::string>();
    EXPECT_EQ(get_json(maps + "/" + edited)["obstacles"]["count"], 0);
    sent("@..");
    const auto store = open();
    EXPECT_FALSE(store->holds(one));  // it was sent before two others
    EXPECT_TRUE(store->holds(edited));
    EXPECT_EQ(other().Delete(maps + "/" + edited)->status, 204);
    EXPECT_FALSE(store->holds(edited));
    EXPECT_THROW(store->keep(store->sent().front(), Connectivity::four, "another map"), http::Problem);
}

TEST_F(SharedStoreTest, NoMoreAreLiveThanMayBeOnAllServers) {
    options_.limits.live_missions = 3;
    begin_both();
    const std::string sent = "type octile\nheight 1\nwidth 3\nmap\n...\n";
    Json request = rover_mission;
    request["map"] = Json::parse(post(maps, sent, octets).body)["id"];
    request["agents"][0].update({{"start", {0, 0}}, {"goal", {2, 0}}});
    std::atomic<int> taken = 0;
    std::vector<std::thread> clients;
    for (int i = 0; i < 8; ++i) {
        clients.emplace_back([&, i] {
            httplib::Client asking = i % 2 == 0 ? client() : other();
            if (asking.Post(missions, request.dump(), "application/json")->status == 201) ++taken;
        });
    }
    for (std::thread& client : clients) client.join();
    EXPECT_EQ(taken, 3);
    EXPECT_EQ(open()->count(), 3U);
}

TEST_F(SharedStoreTest, ServersThatBeginTogetherMakeOneStore) {
    std::vector<std::thread> servers;
    std::atomic<int> opened = 0;
    for (int i = 0; i < 4; ++i) {
        servers.emplace_back([&] {
            open();
            ++opened;
        });
    }
    for (std::thread& server : servers) server.join();
    EXPECT_EQ(opened, 4);
}

TEST_F(SharedStoreTest, LostConnectionsAreMadeAnew) {
    begin_both();
    const std::string path = begun();
    const Listening listening(other(), path + "/events");
    listening.await(1);
    run_sql("SELECT pg_terminate_backend(pid) FROM pg_stat_activity WHERE application_name = 'waybreaker'");
    EXPECT_EQ(post_json(path + "/reports", state(1, 1))["revision"], 1);
    listening.await(2);
}

TEST_F(SharedStoreTest, SaysThatItCannotBeUsedAndComesBack) {
    begin();
    const std::string path = begun();
    run_sql("ALTER SCHEMA waybreaker RENAME TO elsewhere");
    for (const std::string& asked : {missions, path, path + "/plan", path + "/events", maps})
        EXPECT_EQ(kind(get_json(asked, 503)), "/problems/store-unusable") << asked;
    EXPECT_EQ(remove(path).status, 503);
    EXPECT_EQ(remove(maps + "/upload-1").status, 503);
    EXPECT_EQ(kind(post_json(path + "/reports", state(1, 1), 503)), "/problems/store-unusable");
    EXPECT_EQ(kind(post_json(missions, rover_mission, 503)), "/problems/store-unusable");
    EXPECT_EQ(get("/metrics").body.find("waybreaker_missions_live"), std::string::npos);
    EXPECT_EQ(post_json(maps + "/house.map/plan", house_mission)["status"], "solved");  // needs no store
    run_sql("ALTER SCHEMA elsewhere RENAME TO waybreaker");
    EXPECT_EQ(post_json(path + "/reports", state(1, 1))["revision"], 1);
}

TEST_F(SharedStoreTest, ATurnThatIsLostAddsNothing) {
    const auto store = open();
    store->add({.id = "one", .map = "a.map", .archive = "upload-1"}, archived_map, first_report, many_missions);
    ReportRecord report = first_report;
    report.sequence = 1;
    report.revision = 1;
    const auto lost = store->turn("one");
    run_sql("SELECT pg_terminate_backend(pid) FROM pg_stat_activity WHERE state = 'idle in transaction'");
    const auto turn = store->turn("one");
    EXPECT_THROW(lost->add(report), http::Problem);
    EXPECT_EQ(store->mission("one")->revision, 0);
    EXPECT_TRUE(turn->add(report));
}

TEST_F(SharedStoreTest, ATurnEndsWhenItTakesLongerThanAPlanMay) {
    options_.limits.seconds = 0.001;  // and what a server may take beside
    const auto store = open();
    const auto other_store = open();
    store->add({.id = "one", .map = "a.map", .archive = "upload-1"}, archived_map, first_report, many_missions);
    ReportRecord report = first_report;
    report.sequence = 1;
    report.revision = 1;
    const auto held = store->turn("one");
    const auto turn = other_store->turn("one");  // waits
    EXPECT_THROW(held->add(report), http::Problem);
    EXPECT_TRUE(turn->add(report));
}

TEST_F(SharedStoreTest, AMissionCanEndWhileItIsRevised) {
    const auto store = open();
    store->add({.id = "one", .map = "a.map", .archive = "upload-1"}, archived_map, first_report, many_missions);
    const auto turn = store->turn("one");
    EXPECT_TRUE(store->remove("one"));
    ReportRecord report = first_report;
    report.sequence = 1;
    EXPECT_FALSE(turn->add(report));
}

TEST_F(SharedStoreTest, RefusesOtherVersions) {
    open();
    run_sql("UPDATE waybreaker.format SET version = 99");
    EXPECT_NE(refusal(options_.store).find("another version"), std::string::npos) << refusal(options_.store);
}

TEST_F(SharedStoreTest, RefusalsSayWhyAndNeverThePassword) {
    const auto says = [this](const std::string& url, const std::string& why) {
        const std::string message = refusal(url);
        EXPECT_NE(message.find(why), std::string::npos) << url << ": " << message;
        EXPECT_EQ(message.find("sesame"), std::string::npos) << message;
    };
    const std::string socket = test_postgres().substr(test_postgres().find("host="));
    const std::string folder = socket.substr(0, socket.find('&'));
    says("postgresql://guarded:wrong%20sesame@/postgres?" + folder, "password authentication failed");
    says("postgresql://guarded@/postgres?" + folder, "no password supplied");
    says("postgresql:///nowhere?" + socket, "\"nowhere\" does not exist");
    says("postgresql://anna:sesame@/postgres?host=/none", "is it running");
    says("postgresql://anna:open@sesame@host/postgres", "%40");
    says("postgresql://anna:open/sesame@host/postgres", "%40");
    says("postgresql://anna:open%zzsesame@host/postgres", "is no URL");
    says("postgresql://anna:sesame@host:port/postgres", "cannot connect");
    says("postgresql:///postgres?sesame=1&" + socket, "is no URL");
    const std::string right = "postgresql://guarded:open%20sesame@/postgres?" + folder;
    says(right, "permission denied");  // to make a schema
}

}  // namespace
}  // namespace waybreaker::service
