// Events of live missions: one for each report, resumed after the last one a client has got.
#include <algorithm>
#include <chrono>
#include <thread>

#include "listening.hpp"
#include "live_mission.hpp"
#include "wire.hpp"

namespace waybreaker::service {
namespace {

using namespace std::chrono_literals;

class MissionEventsTest : public LiveMissionServer {
  protected:
    void await_metric(const std::string& line) const {
        const auto deadline = std::chrono::steady_clock::now() + 30s;
        while (get("/metrics").body.find(line) == std::string::npos) {
            ASSERT_LT(std::chrono::steady_clock::now(), deadline) << line;
            std::this_thread::sleep_for(20ms);
        }
    }
};

TEST_F(MissionEventsTest, TellWhatChangesUntilTheMissionIsDeleted) {
    begin();
    const std::string path = begun();
    Listening first(client(), path + "/events");
    Listening second(client(), path + "/events");
    ASSERT_EQ(first.await(1).size(), 1U);
    ASSERT_EQ(second.await(1).size(), 1U);
    Json answer = post_json(path + "/reports", state(7, 1));
    post_json(path + "/reports", state(7, 1));  // again: no news
    post_json(path + "/reports", state(9, 1.5, gap_blocked));
    const std::vector<Json> events = first.await(3);
    EXPECT_EQ(ids_of(events), (std::vector<std::string>{"0", "7", "9"}));
    EXPECT_EQ(events[0]["event"], "revision");
    EXPECT_EQ(Json::parse(events[0]["data"].get<std::string>())["changed"], Json::array({"rover"}));
    answer.erase("plan");
    EXPECT_EQ(Json::parse(events[1]["data"].get<std::string>()), answer);
    EXPECT_EQ(Json::parse(events[2]["data"].get<std::string>())["status"], "no_plan");
    remove(path);
    first.to_the_end();
    second.to_the_end();
    EXPECT_TRUE(first.ended_well());
    EXPECT_EQ(first.text(), second.text());
    EXPECT_EQ(first.events().back()["event"], "deleted");
}

TEST_F(MissionEventsTest, AreResumed) {
    options_.store = new_store();
    begin();
    const std::string path = begun();
    for (int i = 1; i <= 3; ++i) post_json(path + "/reports", state(2 * i, i));
    end();
    begin();
    const Listening anew(client(), path + "/events");
    const Listening resumed(client(), path + "/events", {{"Last-Event-ID", "2"}});
    EXPECT_EQ(ids_of(anew.await(1)), std::vector<std::string>{"6"});
    EXPECT_EQ(ids_of(resumed.await(2)), (std::vector<std::string>{"4", "6"}));
    post_json(path + "/reports", state(8, 4));
    EXPECT_EQ(ids_of(anew.await(2)), (std::vector<std::string>{"6", "8"}));
    EXPECT_EQ(ids_of(resumed.await(3)), (std::vector<std::string>{"4", "6", "8"}));
    for (const char* id : {"9", "x", "-1", "99999999999999999999"}) {
        EXPECT_EQ(get(path + "/events", {{"Last-Event-ID", id}}).status, 400) << id;
    }
    get_json(missions + "/none/events", 404);
}

TEST_F(MissionEventsTest, ClientsThatLeaveAreForgotten) {
    begin();
    const std::string path = begun();
    Listening listening(client(), path + "/events");
    listening.await(1);
    await_metric("waybreaker_event_streams 1\n");
    listening.leave();
    await_metric("waybreaker_event_streams 0\n");
}

TEST_F(MissionEventsTest, EndWithTheServer) {
    begin();
    const std::string path = begun();
    Listening listening(client(), path + "/events");
    listening.await(1);
    end();
    listening.to_the_end();
    EXPECT_TRUE(listening.ended_well());
}

TEST_F(MissionEventsTest, GiveWayToOtherClients) {
    options_.limits.connections = 3;
    begin();
    const std::string path = begun();
    const Listening first(client(), path + "/events");
    const Listening second(client(), path + "/events");
    const Listening third(client(), path + "/events");
    first.await(1);
    second.await(1);
    third.await(1);
    EXPECT_EQ(get("/healthz").status, 200);
}

TEST_F(MissionEventsTest, AConnectionGoesOnAfterThem) {
    begin();
    const std::string path = begun();
    const Wire wire(port());
    wire.send("HEAD " + path + "/events HTTP/1.1\r\nHost: localhost\r\n\r\n");
    wire.send("GET " + path + "/events HTTP/1.1\r\nHost: localhost\r\n\r\n");
    await_metric("waybreaker_event_streams 1\n");
    remove(path);
    wire.send("GET /healthz HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n");
    const std::string all = wire.rest();
    EXPECT_EQ(std::ranges::count(all, '{'), 3);  // the first event, `deleted`, and health
    EXPECT_NE(all.find("0\r\n\r\nHTTP/1.1 200 OK"), std::string::npos) << all;
    EXPECT_TRUE(all.ends_with("{\"status\": \"ok\"}\n")) << all;
}

}  // namespace
}  // namespace waybreaker::service
