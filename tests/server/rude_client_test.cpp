// Clients that do not speak HTTP, speak it slowly, without end, or hang up.
#include <chrono>
#include <thread>

#include "live_server.hpp"
#include "server/client_stream.hpp"
#include "wire.hpp"

namespace waybreaker::server {
namespace {

using namespace std::chrono_literals;

class RudeClientTest : public LiveServer {
  protected:
    RudeClientTest() {
        options_.limits.patience = 0.5;
        options_.limits.idle = 0.5;
        options_.limits.upload_bytes = 100000;
    }
};

TEST_F(RudeClientTest, SlowOnesDoNotHoldTheirPlace) {
    options_.limits.connections = 2;
    begin();
    const Wire silent(port());
    const Wire slow(port());
    std::jthread drip([&slow](const std::stop_token& stop) {
        while (!stop.stop_requested() && slow.send("G")) std::this_thread::sleep_for(50ms);
    });
    const auto began = std::chrono::steady_clock::now();
    EXPECT_EQ(get("/healthz").status, 200);  // waits until one of the others is told to go
    EXPECT_LT(std::chrono::steady_clock::now() - began, 5s);
}

TEST(ClientStream, GivesUpOnWhoTakesNoAnswer) {
    int ends[2];
    ASSERT_EQ(::socketpair(AF_UNIX, SOCK_STREAM, 0, ends), 0);
    const int small = 4096;
    ::setsockopt(ends[0], SOL_SOCKET, SO_SNDBUF, &small, sizeof small);
    const auto began = std::chrono::steady_clock::now();
    {
        ClientStream client(ends[0], {.writing = 100ms});
        const std::string piece(1000, 'x');
        while (client.write(piece.data(), piece.size()) >= 0) continue;
    }
    const auto time = std::chrono::steady_clock::now() - began;
    EXPECT_GE(time, 100ms);
    EXPECT_LT(time, 5s);
    ::close(ends[0]);
    ::close(ends[1]);
}

TEST_F(RudeClientTest, HeadersEnd) {
    begin();
    const Wire wire(port());
    ASSERT_TRUE(wire.send("GET /healthz HTTP/1.1\r\n"));
    const std::string header = "X-Much: " + std::string(1000, 'x') + "\r\n";
    bool open = true;
    for (int i = 0; i < 10000 && open; ++i) open = wire.send(header);
    EXPECT_FALSE(open) << "ten megabytes of headers were read";
    EXPECT_EQ(get("/healthz").status, 200);
}

TEST_F(RudeClientTest, NoiseAndHangingUpDoNoHarm) {
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
}  // namespace waybreaker::server
