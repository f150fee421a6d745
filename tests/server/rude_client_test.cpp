// Clients that do not speak HTTP, speak it slowly, without end, or hang up.
#include <chrono>
#include <thread>

#include "live_server.hpp"
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
