// Connections: a thread for each, so many at most. One that is between two requests gives its place to who comes.
#pragma once

#include <httplib.h>

#include <condition_variable>
#include <cstddef>
#include <functional>
#include <mutex>
#include <set>

namespace waybreaker::server {

class Connections {
  public:
    explicit Connections(std::size_t most) : most_(most) {}

    // Serves on a thread of its own; waits until there is place for one.
    void open(std::function<void()> serve);
    // Sends away who is between two requests, and waits until all are served.
    void close();

    // Whether a connection may wait for another request; while it does, it can be sent away: its socket then reads as
    // ended by the client.
    bool begin_waiting(int socket);
    // Whether it may stay: nobody has sent it away.
    bool end_waiting(int socket);
    // Whether the connection that asks must give up its place: somebody waits for one, or this is the end.
    bool must_leave();

  private:
    void send_away(int socket);

    std::size_t most_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::size_t open_ = 0;
    std::set<int> waiting_;  // sockets
    bool one_must_leave_ = false;
    bool closing_ = false;
};

}  // namespace waybreaker::server
