// Client stream: a connection as httplib reads and writes it, with a patience that ends: reading a request is bounded
// in time and bytes, headers included, and so is the time a client takes to receive its answer.
#pragma once

#include <httplib.h>

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>

namespace waybreaker::server {

struct Patience {
    std::chrono::milliseconds reading{10000};  // of a whole request
    std::chrono::milliseconds writing{
        10000};                             // waited for a client that receives an answer, beside what its size takes
    std::chrono::milliseconds idle{30000};  // between an answer and the next request
    std::size_t bytes = std::size_t{1} << 25;  // of a whole request
};

class ClientStream : public httplib::Stream {
  public:
    ClientStream(int socket, const Patience& patience) : socket_(socket), patience_(patience) { begin_request(); }

    // The patience begins anew.
    void begin_request();
    // Whether a request begins within the time between two. Part of it may have come already.
    bool wait_for_request() const;
    // Bytes of the request that have been taken.
    std::uint64_t taken() const { return taken_; }
    // Takes so many bytes and forgets them; whether they came.
    bool skip(std::uint64_t count);

    // Whether the client is still there. One that only ends its side of the connection counts as gone.
    bool is_there() const;
    // We have ended its side ourselves: that says nothing of the client any more.
    void take_for_there() { taken_for_there_ = true; }

    bool is_readable() const override;
    bool is_writable() const override;
    ssize_t read(char* target, std::size_t size) override;
    ssize_t write(const char* bytes, std::size_t size) override;
    void get_remote_ip_and_port(std::string& ip, int& port) const override;
    void get_local_ip_and_port(std::string& ip, int& port) const override;
    socket_t socket() const override { return socket_; }

  private:
    std::chrono::milliseconds left() const;
    bool fill();

    int socket_;
    Patience patience_;
    std::chrono::steady_clock::time_point deadline_;
    std::array<char, 16384> buffer_{};
    std::size_t begin_ = 0;
    std::size_t end_ = 0;
    bool taken_for_there_ = false;
    std::uint64_t taken_ = 0;
    std::uint64_t written_ = 0;
    std::chrono::nanoseconds waited_{0};  // for a client that receives
};

// A socket closed with bytes unread resets the connection, and the client may lose its answer: so those that are
// already on their way are read first, for a moment.
void close_gently(int socket);

}  // namespace waybreaker::server
