#include "server/connections.hpp"

#include <sys/socket.h>

#include <thread>
#include <utility>

namespace waybreaker::server {

void Connections::open(std::function<void()> serve) {
    {
        std::unique_lock lock(mutex_);
        if (open_ == most_ && !waiting_.empty()) {
            send_away(*waiting_.begin());
        } else {
            one_must_leave_ = open_ == most_;
        }
        changed_.wait(lock, [this] { return open_ < most_; });
        one_must_leave_ = false;
        ++open_;
    }
    std::thread([this, serve = std::move(serve)] {
        serve();
        const std::scoped_lock lock(mutex_);
        --open_;
        changed_.notify_all();  // under the lock: afterwards all this may be gone
    }).detach();
}

void Connections::close() {
    std::unique_lock lock(mutex_);
    closing_ = true;
    while (!waiting_.empty()) send_away(*waiting_.begin());
    changed_.wait(lock, [this] { return open_ == 0; });
}

bool Connections::begin_waiting(int socket) {
    const std::scoped_lock lock(mutex_);
    if (closing_ || std::exchange(one_must_leave_, false)) return false;
    waiting_.insert(socket);
    return true;
}

bool Connections::end_waiting(int socket) {
    const std::scoped_lock lock(mutex_);
    return waiting_.erase(socket) > 0;
}

bool Connections::must_leave() {
    const std::scoped_lock lock(mutex_);
    return closing_ || std::exchange(one_must_leave_, false);
}

void Connections::send_away(int socket) {
    waiting_.erase(socket);
    ::shutdown(socket, SHUT_RD);
}

}  // namespace waybreaker::server
