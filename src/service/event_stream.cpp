#include "service/event_stream.hpp"

#include <utility>

#include "http/server_event.hpp"

namespace waybreaker::service {

void EventStream::push(std::string event) {
    const std::scoped_lock lock(mutex_);
    if (!ended_) text_ += event;
}

void EventStream::end() {
    const std::scoped_lock lock(mutex_);
    ended_ = true;
}

std::string EventStream::take() {
    constexpr std::chrono::seconds silence(15);
    const std::scoped_lock lock(mutex_);
    const Clock::time_point now = Clock::now();
    if (text_.empty() && (ended_ || now - last_ < silence)) return "";
    last_ = now;
    return text_.empty() ? std::string(http::empty_event) : std::exchange(text_, {});
}

bool EventStream::over() const {
    const std::scoped_lock lock(mutex_);
    return ended_ && text_.empty();
}

}  // namespace waybreaker::service
