// Connections that serve one request after the other: where each ends, which one is the last, and who gives way.
#include <chrono>

#include "live_server.hpp"
#include "server/framing.hpp"
#include "server/gzip.hpp"
#include "wire.hpp"

namespace waybreaker::server {
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
    // All that the server says to that, until it hangs up.
    std::string said(const std::string& text) const {
        const Wire wire(port());
        wire.send(text);
        return wire.rest();
    }
};

TEST(Framing, WhatCanBeFollowed) {
    const auto request = [](const httplib::Headers& headers, const std::string& version = "HTTP/1.1") {
        httplib::Request made;
        made.headers = headers;
        made.version = version;
        return made;
    };
    EXPECT_TRUE(may_be_followed(request({{"Host", "a"}})));
    EXPECT_TRUE(may_be_followed(request({{"Host", "a"}, {"Content-Length", "12"}, {"Connection", "keep-alive"}})));
    EXPECT_EQ(body_length(request({{"Content-Length", "12"}})), 12U);
    EXPECT_EQ(body_length(request({})), 0U);
    const std::vector<httplib::Headers> last{{{"Host", "a"}, {"Connection", "TE, Close"}},
                                             {{"Host", "a"}, {"Transfer-Encoding", "chunked"}}};
    for (const auto& headers : last) {
        EXPECT_FALSE(may_be_followed(request(headers)));
        EXPECT_NO_THROW(check_framing(request(headers)));
    }
    EXPECT_FALSE(may_be_followed(request({{"Host", "a"}}, "HTTP/1.0")));
    EXPECT_NO_THROW(check_framing(request({}, "HTTP/1.0")));
    const std::vector<httplib::Headers> wrong{
        {},
        {{"Host", "a"}, {"Host", "b"}},
        {{"Host", "a"}, {"Content-Length", "1"}, {"Content-Length", "2"}},
        {{"Host", "a"}, {"Content-Length", "1"}, {"Transfer-Encoding", "chunked"}},
        {{"Host", "a"}, {"Content-Length", "+1"}},
        {{"Host", "a"}, {"Content-Length", "1, 1"}},
        {{"Host", "a"}, {"Content-Length", "99999999999999999999"}},
        {{"Host", "a"}, {"Transfer-Encoding", "gzip, chunked"}},
        {{"Host", "a"}, {"Transfer-Encoding", "identity"}},
        {{"Host", "a"}, {"Content-Length ", "1"}},
        {{"Host", "a"}, {" folded", "1"}}};
    for (const auto& headers : wrong) {
        EXPECT_THROW(check_framing(request(headers)), Problem);
        EXPECT_FALSE(may_be_followed(request(headers)));
    }
}

TEST(Gzip, IsGivenToWhoTakesIt) {
    for (const char* taken : {"gzip", "deflate, GZIP;q=0.5", "*", "br;q=1.0, *;q=0.1", "x-gzip", " gzip ; q=1"}) {
        EXPECT_TRUE(accepts_gzip(taken)) << taken;
    }
    for (const char* refused : {"", "br", "gzip;q=0", "gzip; q=0.000, *", "identity", "*;q=0", "gzippy"}) {
        EXPECT_FALSE(accepts_gzip(refused)) << refused;
    }
}

TEST_F(ConnectionTest, ServesOneRequestAfterTheOther) {
    begin();
    const std::string answers = said(health + plan(house_mission.dump()) + plan("[]") +
                                     "GET /nowhere HTTP/1.1\r\nHost: "
                                     "localhost\r\nContent-Length: 3\r\n\r\nabc" +
                                     health);
    EXPECT_EQ(count(answers, "HTTP/1.1 200 "), 3);
    EXPECT_EQ(count(answers, "HTTP/1.1 400 "), 1);
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
        plan_head("Transfer-Encoding: chunked\r\n") + "2\r\n{}\r\n0\r\n\r\n",
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

TEST_F(ConnectionTest, WhoIsIdleGivesWay) {
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

TEST_F(ConnectionTest, WhoIsIdleDoesNotHoldUpTheEnd) {
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
}  // namespace waybreaker::server
