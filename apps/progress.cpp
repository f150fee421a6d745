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
namespace {

void tick(const std::stop_token& stop, const std::string& activity) {
    std::mutex mutex;
    std::condition_variable_any stopped;
    std::unique_lock lock(mutex);
    const auto passes_a_second = [&] {
        return !stopped.wait_for(lock, stop, std::chrono::seconds(1), [&] { return stop.stop_requested(); });
    };
    int seconds = 0;
    while (passes_a_second()) fmt::print(stderr, "\r{} ({} s)", activity, ++seconds);
    if (seconds > 0) fmt::print(stderr, "\r\033[K");
}

}  // namespace

Progress::Progress(std::string activity) {
    if (isatty(STDERR_FILENO) != 1) return;
    ticker_ = std::jthread([activity = std::move(activity)](const std::stop_token& stop) { tick(stop, activity); });
}

}  // namespace waybreaker::apps
