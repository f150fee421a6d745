#include "server/connections.hpp"

#include <thread>
#include <utility>

namespace waybreaker::server {

void Connections::enqueue(std::function<void()> serve) {
    {
        std::unique_lock lock(count_->mutex);
        count_->changed.wait(lock, [this] { return count_->open < most_; });
        ++count_->open;
    }
    std::thread([serve = std::move(serve), count = count_] {
        serve();
        const std::scoped_lock lock(count->mutex);
        --count->open;
        count->changed.notify_all();
    }).detach();
}

void Connections::shutdown() {
    std::unique_lock lock(count_->mutex);
    count_->changed.wait(lock, [this] { return count_->open == 0; });
}

}  // namespace waybreaker::server
