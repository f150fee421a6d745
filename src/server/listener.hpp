// Listener: accepts connections and reads and writes them all on one thread; those who answer have a few more. A client
// that is slow costs a socket. When there are too many connections, those that ask nothing, or dawdle, give way to
// those that come.
#pragma once

#include <chrono>
#include <cstddef>
#include <memory>
#include <string>

#include "server/exchange.hpp"

namespace waybreaker::server {

struct Patience {
    std::chrono::milliseconds reading{10000};  // of a whole request
    // Waited for a client that receives an answer, beside what its size takes.
    std::chrono::milliseconds writing{10000};
    std::chrono::milliseconds idle{30000};  // between an answer and the next request
};

struct ListenerOptions {
    std::string host;
    int port = 0;  // 0: any that is free
    Patience patience;
    std::size_t connections = 256;
    std::size_t connections_of_client = 0;  // 0: half of them, but all for clients of this machine
    std::size_t body_bytes = std::size_t{32} << 20;
    Fields headers;  // of every answer that does not say otherwise
};

class Listener {
  public:
    // Binds. Throws InputError if that fails.
    Listener(ListenerOptions options, Reception& reception);
    ~Listener();
    Listener(const Listener&) = delete;
    Listener& operator=(const Listener&) = delete;

    int port() const;
    // Once. Until it is told to stop and what has begun is answered.
    void run();
    void stop();  // from any thread

  private:
    class Hall;
    std::unique_ptr<Hall> hall_;
};

}  // namespace waybreaker::server
