// Connections: a thread for each, so many at most; who comes later waits until one is free.
#pragma once

#include <httplib.h>

#include <condition_variable>
#include <cstddef>
#include <functional>
#include <memory>
#include <mutex>

namespace waybreaker::server {

class Connections : public httplib::TaskQueue {
  public:
    explicit Connections(std::size_t most) : most_(most) {}

    void enqueue(std::function<void()> serve) override;
    // Waits until all are served.
    void shutdown() override;

  private:
    // Outlives the last thread, which may still be leaving when shutdown() returns.
    struct Count {
        std::mutex mutex;
        std::condition_variable changed;
        std::size_t open = 0;
    };
    std::size_t most_;
    std::shared_ptr<Count> count_ = std::make_shared<Count>();
};

}  // namespace waybreaker::server
