// Clients that do not speak HTTP, are slow, never finish, or disconnect.
#include <sys/resource.h>
#include <unistd.h>

#include <chrono>
#include <thread>

#include "http/malformed_requests.hpp"
#include "live_server.hpp"
#include "streaming_client.hpp"
#include "wire.hpp"

namespace waybreaker::service {
namespace {

using namespace std::chrono_literals;

class MisbehavingClientTest : public LiveServer {
  protected:
    MisbehavingClientTest() {
        options_.limits.timeout = 0.5;
        options_.limits.idle = 0.5;
        options_.limits.upload_bytes = 100000;
    }
};

TEST_F(MisbehavingClientTest, SlowOnesDoNotHoldTheirSlot) {
    options_.limits.connections = 2;
    begin();
    const Wire silent(port());
    const Wire slow(port());
    std::jthread drip([&slow](const std::stop_token& stop) {
        while (!stop.stop_requested() && slow.send("G")) std::this_thread::sleep_for(50ms);
    });
    const auto began = std::chrono::steady_clock::now();
    EXPECT_EQ(get("/healthz").status, 200);  // waits until one of the others is closed
    EXPECT_LT(std::chrono::steady_clock::now() - began, 5s);
}

TEST_F(MisbehavingClientTest, HalfRequestsTimeOut) {
    begin();
    const Wire wire(port());
    wire.send("GET /healthz HTTP/1.1\r\n");
    EXPECT_TRUE(wire.rest().starts_with("HTTP/1.1 408 "));
    const Wire body(port());
    body.send(
        "POST /api/v1/maps/house.map/plan HTTP/1.1\r\nHost: localhost\r\nContent-Type: application/json\r\n"
        "Content-Length: 50\r\n\r\n{");
    EXPECT_TRUE(body.rest().starts_with("HTTP/1.1 408 "));
    const Wire silent(port());
    EXPECT_EQ(silent.rest(), "");
}

TEST_F(MisbehavingClientTest, ManyHalfRequestsDelayNobody) {
    options_.limits.connections = 20;
    options_.limits.timeout = 60;
    begin();
    std::vector<std::unique_ptr<Wire>> slow;
    for (int i = 0; i < 60; ++i) {
        slow.push_back(std::make_unique<Wire>(port()));
        slow.back()->send(i % 2 == 0 ? "GET /healthz HTTP/1.1\r\nHost: lo"
                                     : "POST /api/v1/maps HTTP/1.1\r\nHost: localhost\r\nContent-Type: "
                                       "application/octet-stream\r\nContent-Length: 9\r\n\r\nhalf");
    }
    const auto began = std::chrono::steady_clock::now();
    for (int i = 0; i < 60; ++i) EXPECT_EQ(get("/healthz").status, 200);
    EXPECT_LT(std::chrono::steady_clock::now() - began, 30s);
}

// No more files can be opened, but for a few.
class FewFiles {
  public:
    explicit FewFiles(rlim_t more) {
        ::getrlimit(RLIMIT_NOFILE, &before_);
        const int next = ::dup(STDIN_FILENO);
        ::close(next);
        const rlimit lowered{rlim_t(next) + more, before_.rlim_max};
        ::setrlimit(RLIMIT_NOFILE, &lowered);
    }
    FewFiles(const FewFiles&) = delete;
    FewFiles& operator=(const FewFiles&) = delete;
    ~FewFiles() { ::setrlimit(RLIMIT_NOFILE, &before_); }

  private:
    rlimit before_{};
};

TEST_F(MisbehavingClientTest, IdleOnesGiveWayWhereFewFilesCanBeOpened) {
    options_.limits.timeout = 600;
    options_.limits.idle = 600;
    Service service(options_);
    // They are there before the server: its connections alone count against the limit.
    std::vector<std::unique_ptr<Wire>> idle;
    for (int i = 0; i < 800; ++i) idle.push_back(std::make_unique<Wire>(service.port()));
    const Wire wire(service.port());
    wire.send("GET /healthz HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n");
    const FewFiles few(20);
    std::thread running([&] { service.run(); });
    const auto began = std::chrono::steady_clock::now();
    EXPECT_TRUE(wire.rest().starts_with("HTTP/1.1 200 "));
    // A pause for each that gives way would make 78 seconds.
    EXPECT_LT(std::chrono::steady_clock::now() - began, 30s);
    service.stop();
    running.join();
}

TEST_F(MisbehavingClientTest, ConnectionsOfOneClientAreLimited) {
    put("maps/thicket.map", thicket(300));
    options_.limits.connections_of_client = 2;
    options_.limits.timeout = 60;
    begin();
    // The client's own connections without a complete request are closed for new ones;
    const Wire first(port());
    const Wire second(port());
    first.send("GET /heal");
    EXPECT_EQ(get("/healthz").status, 200);
    // if there are none, a new one is refused.
    StreamingClient one(client(), "/api/v1/maps/thicket.map/plan", long_mission(300));
    StreamingClient other(client(), "/api/v1/maps/thicket.map/plan", long_mission(300));
    EXPECT_TRUE(Wire(port()).rest().starts_with("HTTP/1.1 503 "));
    EXPECT_FALSE(one.done() || other.done());
}

TEST_F(MisbehavingClientTest, UnreadResponsesTimeOut) {
    begin();
    const Wire wire(port());
    const std::string request = "GET /api/v1/openapi.json HTTP/1.1\r\nHost: localhost\r\n\r\n";
    const auto began = std::chrono::steady_clock::now();
    // Until the sockets' buffers are full, which takes megabytes, and the write timeout expires.
    bool open = true;
    while (open && std::chrono::steady_clock::now() - began < 30s) open = wire.send(request);
    EXPECT_FALSE(open) << "gigabytes of answers were made that nobody read";
}

TEST_F(MisbehavingClientTest, MalformedRequestsAreRefusedAndNothingAfterThemIsRead) {
    begin();
    const std::string hidden = "GET /healthz HTTP/1.1\r\nHost: localhost\r\n\r\n";
    for (const auto& [why, bytes, status] : http::malformed_requests()) {
        const Wire wire(port());
        wire.send(bytes + hidden);
        const std::string said = wire.rest();
        EXPECT_TRUE(said.starts_with("HTTP/1.1 " + std::to_string(status) + " ")) << why << '\n' << said;
        EXPECT_EQ(said.find("\r\nDate: "), said.rfind("\r\nDate: ")) << why << '\n' << said;
        EXPECT_NE(said.find("\r\nConnection: close\r\n"), std::string::npos) << why << '\n' << said;
        EXPECT_NE(said.find("application/problem+json"), std::string::npos) << why << '\n' << said;
    }
    EXPECT_EQ(get("/healthz").status, 200);
}

TEST_F(MisbehavingClientTest, EndlessHeadersAreRefused) {
    begin();
    const Wire wire(port());
    ASSERT_TRUE(wire.send("GET /healthz HTTP/1.1\r\n"));
    const std::string header = "X-Much: " + std::string(1000, 'x') + "\r\n";
    bool open = true;
    for (int i = 0; i < 10000 && open; ++i) open = wire.send(header);
    EXPECT_FALSE(open) << "ten megabytes of headers were read";
    EXPECT_EQ(get("/healthz").status, 200);
}

TEST_F(MisbehavingClientTest, NoiseAndHangingUpDoNoHarm) {
    begin();
    const std::string nul(1, '\0');
    for (const std::string& text :
         {std::string("\r\n\r\n"), "\x16\x03\x01" + nul, std::string("GET\r\n\r\n"),
          "GET " + std::string(100000, '/') + " HTTP/1.1\r\n\r\n",
          std::string("POST /api/v1/maps/house.map/plan HTTP/1.1\r\nHost: localhost\r\nContent-Type: "
                      "application/json\r\nContent-Length: 99999999999999999999\r\n\r\n{"),
          std::string("POST /api/v1/maps/house.map/plan HTTP/1.1\r\nHost: localhost\r\nContent-Type: "
                      "application/json\r\nContent-Length: 50\r\n\r\n{"),
          std::string("POST /api/v1/maps/house.map/plan HTTP/1.1\r\nHost: localhost\r\nContent-Type: "
                      "application/json\r\nTransfer-Encoding: chunked\r\n\r\nzz\r\n"),
          std::string("POST /api/v1/maps/house.map/plan HTTP/1.1\r\nHost: localhost\r\nContent-Type: "
                      "multipart/form-data; boundary=x\r\nContent-Length: 5\r\n\r\n--x--")}) {
        {
            const Wire hangs_up(port());
            hangs_up.send(text);
        }
        const Wire stays(port());
        stays.send(text);
        EXPECT_EQ(stays.rest().find("HTTP/1.1 200"), std::string::npos) << text.substr(0, 60);
    }
    EXPECT_EQ(get("/healthz").status, 200);
}

}  // namespace
}  // namespace waybreaker::service
