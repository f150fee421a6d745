// Event stream: what a client that listens to a mission has yet to be sent. Thread-safe.
#pragma once

#include <chrono>
#include <mutex>
#include <string>

namespace waybreaker::service {

class EventStream {
  public:
    void push(std::string event);
    // After what is there already, nothing more comes.
    void end();

    // What has come since the last call; if nothing has for a while, an event that clients skip.
    std::string take();
    bool over() const;

  private:
    using Clock = std::chrono::steady_clock;

    mutable std::mutex mutex_;
    std::string text_;
    bool ended_ = false;
    Clock::time_point last_ = Clock::now();
};

}  // namespace waybreaker::service
