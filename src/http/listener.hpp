// Listener: accepts connections and does all I/O on one thread; requests are handled on a few more. So a slow client
// costs only a socket. When there are too many connections, idle and slow ones are closed in favour of new ones.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>

#include "http/exchange.hpp"

namespace waybreaker::http {

struct Timeouts {
    std::chrono::milliseconds reading{10000};  // for a whole request to arrive
    // For a client to take a response, in addition to what its size allows.
    std::chrono::milliseconds writing{10000};
    std::chrono::milliseconds idle{30000};  // between a response and the next request
};

struct ListenerOptions {
    std::string host;
    int port = 0;  // 0: any that is free
    Timeouts timeouts;
    std::size_t connections = 256;
    std::size_t connections_of_client = 0;  // 0: half of `connections`, all for clients on this machine
    std::size_t body_bytes = std::size_t{32} << 20;
    Fields headers;  // defaults for every response
    // Whether all bodies that are received may take so many bytes from now on; fewer than before they always may.
    // Called on the I/O thread.
    std::function<bool(std::size_t bytes)> hold = [](std::size_t) { return true; };
};

class Listener {
  public:
    // Binds. Throws InputError if that fails.
    Listener(ListenerOptions options, RequestHandler& handler);
    ~Listener();
    Listener(const Listener&) = delete;
    Listener& operator=(const Listener&) = delete;

    int port() const;
    // Call once. Returns after stop(), when all requests in progress are answered.
    void run();
    void stop();  // from any thread

  private:
    class Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace waybreaker::http
