// Long plans: queueing, progress events, and cancellation when the client disconnects.
#include <sys/socket.h>

#include <chrono>
#include <cmath>
#include <new>
#include <stdexcept>

#include "live_server.hpp"
#include "service/failure.hpp"
#include "streaming_client.hpp"
#include "waybreaker/error.hpp"
#include "wire.hpp"

namespace waybreaker::service {
namespace {

using namespace std::chrono_literals;

constexpr int side = 300;

class StreamTest : public LiveServer {
  protected:
    void begin_busy(double seconds) {
        put("maps/thicket.map", thicket(side));
        options_.limits.workers = 1;
        options_.limits.queue = 0;
        options_.limits.seconds = seconds;
        begin();
    }
    std::string metrics() const { return get("/metrics").body; }
    void await(const std::string& line) const {
        const auto deadline = std::chrono::steady_clock::now() + 15s;
        while (metrics().find(line) == std::string::npos) {
            ASSERT_LT(std::chrono::steady_clock::now(), deadline) << line;
            std::this_thread::sleep_for(50ms);
        }
    }
};

TEST_F(StreamTest, ShortPlansStreamToo) {
    begin();
    const auto answer =
        post(maps + "/house.map/plan", house_mission.dump(), "application/json", {{"Accept", "text/event-stream"}});
    EXPECT_EQ(answer.status, 200);
    EXPECT_TRUE(answer.body.starts_with("event: progress\n"));
    const std::size_t plan = answer.body.find("event: plan\n");
    ASSERT_NE(plan, std::string::npos);
    std::string document;
    std::istringstream lines(answer.body.substr(plan));
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("data: ")) document += line.substr(6);
    }
    EXPECT_EQ(Json::parse(document)["status"], "solved");
    const auto refused = post(maps + "/house.map/plan", R"({"mission": {"start": [5, 0], "goal": [0, 0]}})",
                              "application/json", {{"Accept", "text/event-stream"}});
    EXPECT_NE(refused.body.find("event: problem\n"), std::string::npos);
}

TEST_F(StreamTest, BusyServerRefusesFurtherPlans) {
    begin_busy(60);
    StreamingClient streaming(client(), maps + "/thicket.map/plan", long_mission(side));
    post_json(maps + "/house.map/plan", house_mission, 503);
    EXPECT_EQ(get("/healthz").status, 200);
    EXPECT_NE(metrics().find("waybreaker_refused_total 1\n"), std::string::npos);
    EXPECT_FALSE(streaming.done());
}

TEST_F(StreamTest, ThePlannerStopsWhenTheClientGoesAway) {
    begin_busy(60);
    StreamingClient streaming(client(), maps + "/thicket.map/plan", long_mission(side));
    EXPECT_NE(metrics().find("waybreaker_plans_running 1\n"), std::string::npos);
    streaming.leave();
    await("waybreaker_plans_running 0\n");
    EXPECT_NE(metrics().find("waybreaker_stopped_total 1\n"), std::string::npos);
    post_json(maps + "/house.map/plan", house_mission);
}

TEST_F(StreamTest, ThePlannerStopsAlsoWithoutEvents) {
    begin_busy(60);
    {
        const Wire wire(port());
        const std::string body = long_mission(side).dump();
        wire.send(
            "POST /api/v1/maps/thicket.map/plan HTTP/1.1\r\nHost: localhost\r\nContent-Type: application/json\r\n"
            "Content-Length: " +
            std::to_string(body.size()) + "\r\n\r\n" + body);
        await("waybreaker_plans_running 1\n");
    }
    await("waybreaker_plans_running 0\n");
    EXPECT_NE(metrics().find("waybreaker_stopped_total 1\n"), std::string::npos);
    EXPECT_NE(metrics().find("route=\"/api/v1/maps/{id}/plan\",status=\"499\"} 1\n"), std::string::npos);
}

TEST_F(StreamTest, ReportsTheBestPlanAndTheBoundMeanwhile) {
    begin_busy(60);
    const StreamingClient streaming(client(), maps + "/thicket.map/plan", long_mission(side));
    const auto deadline = std::chrono::steady_clock::now() + 15s;
    const auto last = [&streaming] {
        const std::string events = streaming.events();
        const std::size_t end = events.rfind("\n\n");
        const std::size_t data = events.rfind("data: ", end) + 6;
        return Json::parse(events.substr(data, end - data));
    };
    while (!last()["best"].is_number()) {
        ASSERT_LT(std::chrono::steady_clock::now(), deadline);
        std::this_thread::sleep_for(50ms);
    }
    EXPECT_GE(last()["best"], std::sqrt(2.0) * (side - 1));
}

TEST(Failures, InternalDetailsGoToTheLogOnly) {
    const auto failure = [](auto exception) {
        try {
            throw exception;
        } catch (...) {
            return current_failure();
        }
    };
    const Failure ours = failure(std::runtime_error("/etc/secret"));
    EXPECT_EQ(ours.status, 500);
    EXPECT_EQ(ours.detail.find("secret"), std::string::npos);
    EXPECT_EQ(ours.cause, "/etc/secret");
    EXPECT_EQ(failure(1).status, 500);
    EXPECT_EQ(failure(std::bad_alloc()).status, 503);
    EXPECT_EQ(failure(InputError("no")).status, 422);
}

TEST_F(StreamTest, TimeLimitEndsThePlan) {
    begin_busy(0.5);
    const auto began = std::chrono::steady_clock::now();
    const Json plan = post_json(maps + "/thicket.map/plan", long_mission(side));
    EXPECT_LT(std::chrono::steady_clock::now() - began, 20s);
    EXPECT_TRUE(plan["bound"].is_null() || plan["bound"]["gap"] != 0) << "the mission is not long enough for this test";
}

TEST_F(StreamTest, EndingFinishesWhatHasBegun) {
    begin_busy(2);
    StreamingClient streaming(client(), maps + "/thicket.map/plan", long_mission(side));
    end();
    EXPECT_NE(streaming.events().find("event: plan\n"), std::string::npos);
}

}  // namespace
}  // namespace waybreaker::service
