// Where requests begin and end, what is parsed from them, and that malformed ones are refused.
#include "http/request_reader.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "http/malformed_requests.hpp"
#include "http/problem.hpp"

namespace waybreaker::http {
namespace {

constexpr std::size_t limit = 100000;
using State = RequestReader::State;

// The requests parsed from bytes that arrive in pieces of that size, and the status of the error that follows, or 0.
struct Outcome {
    std::vector<Request> requests;
    int status = 0;
};

Outcome outcome(const std::string& bytes, std::size_t piece) {
    RequestReader reader(limit);
    Outcome result;
    try {
        for (std::size_t i = 0; i < bytes.size(); i += piece) {
            reader.put(std::string_view(bytes).substr(i, piece));
            while (reader.advance() == State::whole) result.requests.push_back(reader.take());
        }
    } catch (const Problem& problem) {
        result.status = problem.status();
    }
    return result;
}

Request only_request(const std::string& bytes) {
    const Outcome result = outcome(bytes, bytes.size());
    EXPECT_EQ(result.requests.size(), 1U) << bytes;
    EXPECT_EQ(result.status, 0) << bytes;
    return result.requests.empty() ? Request() : result.requests.front();
}

TEST(RequestReader, TakesNoMalformedRequest) {
    EXPECT_GE(malformed_requests().size(), 60U);
    for (const auto& [why, bytes, status] : malformed_requests()) {
        for (const std::size_t piece : {bytes.size(), std::size_t(1), std::size_t(7)}) {
            const Outcome result = outcome(bytes, piece);
            EXPECT_EQ(result.status, status) << why << ", in pieces of " << piece;
            EXPECT_TRUE(result.requests.empty()) << why;
        }
    }
}

TEST(RequestReader, ReadsOneRequestAfterTheOther) {
    const std::string bytes =
        "GET /a?x=1&y=%41+b&z HTTP/1.1\r\nHost: localhost\r\nAccept:  text/html \r\naccept: x\r\n\r\n"
        "POST /b HTTP/1.1\r\nhost:localhost:80\r\nContent-Length: 005\r\n\r\nhello"
        "\r\nPOST /c%20d HTTP/1.1\r\nHost: [::1]:80\r\ntransfer-encoding: \t Chunked\r\n\r\n"
        "2;a=b;c=\"d;e\"\r\n{}\r\n003\r\nabc\r\n0;x\r\nTrailer: 1\r\nHost: evil.example\r\n\r\n"
        "DELETE http://Other.example:81?q HTTP/1.1\r\nHost: localhost\r\nConnection: te, Close\r\n\r\n"
        "GET / HTTP/1.0\r\n\r\n";
    for (const std::size_t piece : {bytes.size(), std::size_t(1), std::size_t(3), std::size_t(64)}) {
        const auto [requests, status] = outcome(bytes, piece);
        EXPECT_EQ(status, 0);
        ASSERT_EQ(requests.size(), 5U);
        EXPECT_EQ(requests[0].method, "GET");
        EXPECT_EQ(requests[0].path, "/a");
        EXPECT_EQ(requests[0].query.get("y"), "A b");
        EXPECT_EQ(requests[0].query.find("z"), "");
        EXPECT_EQ(requests[0].headers.get("ACCEPT"), "text/html, x") << "lines of one name are one list";
        EXPECT_EQ(requests[0].headers.count("Accept"), 2U);
        EXPECT_EQ(requests[1].body, "hello");
        EXPECT_EQ(requests[2].path, "/c d");
        EXPECT_EQ(requests[2].body, "{}abc");
        EXPECT_EQ(requests[2].headers.get("Host"), "[::1]:80");
        EXPECT_EQ(requests[2].headers.count("Trailer"), 0U);
        EXPECT_EQ(requests[3].path, "/");
        EXPECT_EQ(requests[3].headers.get("Host"), "Other.example:81") << "the address says it, not Host";
        EXPECT_EQ(requests[4].path, "/");
    }
}

TEST(RequestReader, TakesAsManyTrailersAsHeaders) {
    std::string trailers;
    for (int i = 0; i < 99; ++i) trailers += "X-" + std::to_string(i) + ": 1\r\n";
    trailers += "X: " + std::string(30000, 'x') + "\r\n\r\n";
    const std::string bytes = "POST / HTTP/1.1\r\nHost: a\r\nTransfer-Encoding: chunked\r\n\r\n2\r\n{}\r\n00\r\n" +
                              trailers + "GET /next HTTP/1.1\r\nHost: a\r\n\r\n";
    for (const std::size_t piece : {bytes.size(), std::size_t(1), std::size_t(7)}) {
        const auto [requests, status] = outcome(bytes, piece);
        EXPECT_EQ(status, 0);
        ASSERT_EQ(requests.size(), 2U);
        EXPECT_EQ(requests[0].body, "{}");
        EXPECT_EQ(requests[1].path, "/next");
    }
}

TEST(RequestReader, KnowsWhichRequestIsTheLast) {
    const auto may_be_followed = [](const std::string& bytes) {
        RequestReader reader(limit);
        reader.put(bytes);
        EXPECT_EQ(reader.advance(), State::whole);
        return reader.may_be_followed();
    };
    EXPECT_TRUE(may_be_followed("GET / HTTP/1.1\r\nHost: a\r\n\r\n"));
    EXPECT_TRUE(may_be_followed("GET / HTTP/1.1\r\nHost: a\r\nConnection: keep-alive\r\n\r\n"));
    EXPECT_TRUE(may_be_followed("GET / HTTP/1.1\r\nHost: a\r\nTransfer-Encoding: chunked\r\n\r\n0\r\n\r\n"));
    EXPECT_FALSE(may_be_followed("GET / HTTP/1.1\r\nHost: a\r\nConnection: x\r\nConnection: TE, Close\r\n\r\n"));
    EXPECT_FALSE(may_be_followed("GET / HTTP/1.0\r\nConnection: keep-alive\r\n\r\n"));
}

TEST(RequestReader, RefusesBodiesThatAreTooLong) {
    const std::string head = "POST / HTTP/1.1\r\nHost: a\r\n";
    const std::string chunks = "Transfer-Encoding: chunked\r\n\r\n";
    EXPECT_EQ(outcome(head + "Content-Length: 100001\r\n\r\nx", 9).status, too_large);
    EXPECT_EQ(outcome(head + "Content-Length: 999999999999999999\r\n\r\nx", 9).status, too_large);
    EXPECT_EQ(outcome(head + chunks + "186a1\r\nx", 9).status, too_large);
    const std::string chunk = "8000\r\n" + std::string(0x8000, 'x') + "\r\n";
    EXPECT_EQ(outcome(head + chunks + chunk + chunk + chunk + chunk, 4096).status, too_large);
    EXPECT_EQ(outcome(head + chunks + chunk + chunk + chunk + "0\r\n\r\n", 4096).requests.size(), 1U);
}

TEST(RequestReader, SkipsDroppedBodies) {
    RequestReader reader(limit);
    reader.put("POST / HTTP/1.1\r\nHost: a\r\nContent-Length: 5\r\nExpect: 100-Continue\r\n\r\nhe");
    EXPECT_EQ(reader.advance(), State::body);
    EXPECT_EQ(reader.length(), 5U);
    EXPECT_TRUE(reader.expects_continue());
    reader.drop_body();
    reader.put("lloGET /next HTTP/1.1\r\nHost: a\r\n\r\n");
    EXPECT_EQ(reader.advance(), State::whole);
    reader.take();
    EXPECT_EQ(reader.advance(), State::whole);
    EXPECT_EQ(reader.take().path, "/next");
    EXPECT_EQ(reader.advance(), State::idle);
}

TEST(RequestReader, BrowsersLeaveMarksInQueriesAsTheyAre) {
    EXPECT_EQ(only_request("GET /?m={a}|[b]\\^` HTTP/1.1\r\nHost: a\r\n\r\n").query.get("m"), "{a}|[b]\\^`");
}

}  // namespace
}  // namespace waybreaker::http
