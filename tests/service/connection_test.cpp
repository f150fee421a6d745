// Connections that serve several requests: where each request ends, which one is the last, which connection is closed.
#include <chrono>

#include "http/gzip.hpp"
#include "live_server.hpp"
#include "wire.hpp"

namespace waybreaker::service {
namespace {

using namespace std::chrono_literals;

const std::string health = "GET /healthz HTTP/1.1\r\nHost: localhost\r\n\r\n";
const std::string healthy = "{\"status\": \"ok\"}\n";

std::string plan_head(const std::string& more) {
    return "POST /api/v1/maps/house.map/plan HTTP/1.1\r\nHost: localhost\r\nContent-Type: application/json\r\n" + more +
           "\r\n";
}

std::string plan(const std::string& body) {
    return plan_head("Content-Length: " + std::to_string(body.size()) + "\r\n") + body;
}

int count(const std::string& text, const std::string& part) {
    int found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
    return found;
}

class ConnectionTest : public LiveServer {
  protected:
    ConnectionTest() { options_.limits.idle = 0.3; }
    // All that the server sends in response, until it closes the connection.
    std::string said(const std::string& text) const {
        const Wire wire(port());
        wire.send(text);
        return wire.rest();
    }
};

TEST_F(ConnectionTest, ServesOneRequestAfterTheOther) {
    begin();
    const std::string answers = said(health + plan(house_mission.dump()) + plan("[]") +
                                     plan_head("Transfer-Encoding: chunked\r\n") + "2\r\n[]\r\n0\r\nX: 1\r\n\r\n" +
                                     "GET /nowhere HTTP/1.1\r\nHost: "
                                     "localhost\r\nContent-Length: 3\r\n\r\nabc" +
                                     health);
    EXPECT_EQ(count(answers, "HTTP/1.1 200 "), 3);
    EXPECT_EQ(count(answers, "HTTP/1.1 400 "), 2);
    EXPECT_EQ(count(answers, "HTTP/1.1 404 "), 1);
    EXPECT_EQ(count(answers, "Connection: close"), 0);
    EXPECT_TRUE(answers.ends_with(healthy));
}

TEST_F(ConnectionTest, SaysWhichAnswerIsTheLast) {
    begin();
    const std::vector<std::string> last{
        "GET /healthz HTTP/1.1\r\nHost: localhost\r\nConnection: Close\r\n\r\n",
        "GET /healthz HTTP/1.0\r\nHost: localhost\r\nConnection: keep-alive\r\n\r\n",
        "GET /healthz HTTP/1.1\r\n\r\n",
        "GET /healthz\r\n\r\n",
        plan_head("Content-Length: 2\r\nTransfer-Encoding: chunked\r\n") + "2\r\n{}\r\n0\r\n\r\n",
        plan_head("Content-Length: 2\r\nContent-Length: 20\r\n") + "{}",
        "POST /api/v1/maps/house.map/plan HTTP/1.1\r\nHost: localhost\r\nContent-Length: 100000\r\n\r\n"};
    for (const std::string& request : last) {
        const std::string answers = said(request + health);
        EXPECT_EQ(count(answers, "HTTP/1.1 "), 1) << request << answers;
        EXPECT_EQ(count(answers, "Connection: close"), 1) << request << answers;
    }
}

TEST_F(ConnectionTest, NoRequestHidesInABody) {
    begin();
    // Neither of those that are not wanted,
    EXPECT_EQ(count(said("GET /healthz HTTP/1.1\r\nHost: localhost\r\nContent-Length: " +
                         std::to_string(health.size()) + "\r\n\r\n" + health),
                    "HTTP/1.1 "),
              1);
    // nor of those that end early, nor where no length is said.
    EXPECT_EQ(count(said(plan_head("Content-Length: 1\r\n") + "{" + health), "HTTP/1.1 200 "), 1);
    EXPECT_EQ(count(said(plan_head("") + health), "HTTP/1.1 400 "), 1);
}

TEST_F(ConnectionTest, AcceptsWhatTheStandardsAllow) {
    begin();
    for (const char* request : {"GET http://localhost/healthz HTTP/1.1\r\nHost: localhost\r\n\r\n",
                                "GET HTTP://LOCALHOST:8080/healthz?x HTTP/1.1\r\nHost: evil.example\r\n\r\n",
                                "GET /healthz HTTP/1.1\r\nHOST:LocalHost\r\n\r\n",
                                "\r\nGET /%68ealthz HTTP/1.1\r\nHost: [::1]:80 \r\n\r\n"}) {
        const std::string answer = said(request);
        EXPECT_TRUE(answer.starts_with("HTTP/1.1 200 OK\r\n") && answer.ends_with(healthy)) << request << answer;
    }
    EXPECT_TRUE(
        said("GET http://evil.example/healthz HTTP/1.1\r\nHost: localhost\r\n\r\n").starts_with("HTTP/1.1 421 "));
    EXPECT_TRUE(said(plan_head("Content-Length: 2\r\nExpect: a-pony\r\n")).starts_with("HTTP/1.1 417 "));
}

TEST_F(ConnectionTest, SecondLinesOfAHeaderCount) {
    begin();
    const auto status = [this](const std::string& more) {
        return said(plan_head("Content-Length: 2\r\n" + more) + "{}").substr(9, 3);
    };
    EXPECT_EQ(status("Expect: 100-continue\r\nExpect: a-pony\r\n"), "417");
    EXPECT_EQ(status("Content-Encoding: identity\r\nContent-Encoding: gzip\r\n"), "415");
    EXPECT_EQ(status("Content-Type: text/plain\r\n"), "415");
    EXPECT_EQ(status("Origin: http://localhost\r\nOrigin: http://evil.example\r\n"), "403");
    const auto compressed = [this](const std::string& accepted) {
        return said("GET /api/v1/maps/berlin-mitte.tif/obstacles HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n" +
                    accepted + "\r\n")
                   .find("Content-Encoding: gzip") != std::string::npos;
    };
    EXPECT_TRUE(compressed("Accept-Encoding: br\r\nAccept-Encoding: gzip\r\n"));
    EXPECT_FALSE(compressed("Accept-Encoding: br\r\n"));
}

TEST_F(ConnectionTest, AnswersAClientThatHasSentAllAndSaysSo) {
    put("maps/thicket.map", thicket(300));
    begin();
    const auto answered = [this](const std::string& request) {
        const Wire wire(port());
        wire.send(request);
        wire.end_sending();
        return wire.rest();
    };
    EXPECT_TRUE(answered(health).ends_with(healthy));
    EXPECT_NE(answered(plan(house_mission.dump())).find("\"status\": \"solved\""), std::string::npos);
    EXPECT_EQ(count(answered(plan(house_mission.dump()) + plan(house_mission.dump()) + health), "HTTP/1.1 200 "), 3);
    const std::string whole = plan(house_mission.dump());
    EXPECT_EQ(answered(whole.substr(0, whole.size() - 1)), "");
    // A plan that takes longer than the server waits before it looks whether the client is still there.
    Json request{{"mission", {{"start", {0, 0}}, {"goal", {299, 299}}}},
                 {"options", {{"removals", 20}, {"time_limit", 1}}}};
    const std::string body = request.dump();
    const std::string rest =
        "Content-Type: application/json\r\nContent-Length: " + std::to_string(body.size()) + "\r\n";
    const std::string path = "POST /api/v1/maps/thicket.map/plan HTTP/1.";
    for (const char* version : {"1", "0"}) {
        const std::string said = answered(path + version + "\r\nHost: localhost\r\n" + rest + "\r\n" + body);
        EXPECT_EQ(count(said, "HTTP/1.1 200 "), 1) << said.substr(0, 1000);
        EXPECT_EQ(said.starts_with("HTTP/1.1 100 Continue\r\n\r\nHTTP/1.1 200 "), *version == '1')
            << said.substr(0, 100);
        EXPECT_NE(said.find("\"limit_reached\": true"), std::string::npos);
    }
    const std::string events =
        answered(path + "1\r\nHost: localhost\r\nAccept: text/event-stream\r\n" + rest + "\r\n" + body);
    EXPECT_NE(events.find("event: plan\n"), std::string::npos);
    EXPECT_EQ(count(events, "100 Continue"), 0);
}

TEST_F(ConnectionTest, BodiesMayBeCompressed) {
    options_.limits.upload_bytes = 100000;
    begin();
    const auto send = [this](const std::string& coding, const std::string& body) {
        const std::string answer = said(
            plan_head("Content-Encoding: " + coding + "\r\nContent-Length: " + std::to_string(body.size()) + "\r\n") +
            body);
        return answer.substr(0, 12);
    };
    const std::string packed = http::gzip(house_mission.dump(), 9);
    EXPECT_EQ(send("gzip", packed), "HTTP/1.1 200");
    EXPECT_EQ(send("X-GZip", packed), "HTTP/1.1 200");
    EXPECT_EQ(send("identity", house_mission.dump()), "HTTP/1.1 200");
    EXPECT_EQ(send("gzip", house_mission.dump()), "HTTP/1.1 400");
    EXPECT_EQ(send("gzip", packed.substr(0, packed.size() - 1)), "HTTP/1.1 400");
    EXPECT_EQ(send("gzip", packed + "x"), "HTTP/1.1 400");
    EXPECT_EQ(send("gzip", ""), "HTTP/1.1 400");
    const std::string text = house_mission.dump();
    const std::string members = http::gzip(text.substr(0, 9), 9) + http::gzip("", 1) + http::gzip(text.substr(9), 1);
    EXPECT_EQ(send("gzip", members), "HTTP/1.1 200") << "as programs that compress in parallel send it";
    EXPECT_EQ(send("gzip", members.substr(0, members.size() - 1)), "HTTP/1.1 400");
    EXPECT_EQ(send("gzip", http::gzip(std::string(60000, ' '), 9) + http::gzip(std::string(60000, ' '), 9)),
              "HTTP/1.1 413");
    EXPECT_EQ(send("gzip", http::gzip(std::string(100001, ' '), 9)), "HTTP/1.1 413");
    EXPECT_EQ(send("br", packed), "HTTP/1.1 415");
    EXPECT_EQ(send("gzip, gzip", packed), "HTTP/1.1 415");
}

TEST_F(ConnectionTest, IdleConnectionsAreClosedForNewOnes) {
    options_.limits.connections = 2;
    options_.limits.idle = 60;
    begin();
    const Wire first(port());
    const Wire second(port());
    for (const Wire* wire : {&first, &second}) {
        wire->send(health);
        EXPECT_TRUE(wire->until(healthy).ends_with(healthy));
    }
    const auto began = std::chrono::steady_clock::now();
    EXPECT_EQ(get("/healthz").status, 200);
    EXPECT_LT(std::chrono::steady_clock::now() - began, 10s);
    // One of the two is still there.
    first.send(health);
    second.send(health);
    EXPECT_EQ(count(first.until(healthy) + second.until(healthy), healthy), 1);
}

TEST_F(ConnectionTest, IdleConnectionsDoNotDelayShutdown) {
    options_.limits.idle = 60;
    begin();
    const Wire idle(port());
    idle.send(health);
    idle.until(healthy);
    const auto began = std::chrono::steady_clock::now();
    end();
    EXPECT_LT(std::chrono::steady_clock::now() - began, 10s);
    EXPECT_EQ(idle.rest(), "");
}

TEST_F(ConnectionTest, BodiesThatAreRefusedAreNotAskedFor) {
    options_.limits.upload_bytes = 1000;
    begin();
    const std::string expects = "Expect: 100-continue\r\n";
    EXPECT_TRUE(said(plan_head("Content-Length: 5000\r\n" + expects)).starts_with("HTTP/1.1 413 "));
    EXPECT_TRUE(
        said("POST /api/v1/maps/house.map/plan HTTP/1.1\r\nHost: localhost\r\nContent-Length: 2\r\n" + expects + "\r\n")
            .starts_with("HTTP/1.1 415 "));
    const Wire wire(port());
    wire.send(plan_head("Content-Length: 2\r\n" + expects));
    EXPECT_EQ(wire.until("\r\n\r\n"), "HTTP/1.1 100 Continue\r\n\r\n");
    wire.send("[]");
    EXPECT_TRUE(wire.until("problem").starts_with("HTTP/1.1 400 "));
}

}  // namespace
}  // namespace waybreaker::service
