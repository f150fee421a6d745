#include "progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <mutex>
#include <stop_token>
#include <utility>

namespace waybreaker::apps {

struct Progress::Status {
    std::mutex mutex;
    std::condition_variable_any stopped;
    std::string text;
};

Progress::Progress(std::string activity) : status_(std::make_shared<Status>()) {
    if (isatty(STDERR_FILENO) != 1) return;
    ticker_ = std::jthread([status = status_, activity = std::move(activity)](const std::stop_token& stop) {
        std::unique_lock lock(status->mutex);
        const auto passes_a_second = [&] {
            return !status->stopped.wait_for(lock, stop, std::chrono::seconds(1),
                                             [&] { return stop.stop_requested(); });
        };
        int seconds = 0;
        while (passes_a_second()) {
            fmt::print(stderr, "\r\033[K{} ({} s){}{}", activity, ++seconds, status->text.empty() ? "" : ": ",
                       status->text);
        }
        if (seconds > 0) fmt::print(stderr, "\r\033[K");
    });
}

void Progress::update(std::string status) {
    const std::scoped_lock lock(status_->mutex);
    status_->text = std::move(status);
}

}  // namespace waybreaker::apps
