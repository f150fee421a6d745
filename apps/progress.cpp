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

struct Progress::News {
    std::mutex mutex;
    std::condition_variable_any stopped;
    std::string text;
};

Progress::Progress(std::string activity) : news_(std::make_shared<News>()) {
    if (isatty(STDERR_FILENO) != 1) return;
    ticker_ = std::jthread([news = news_, activity = std::move(activity)](const std::stop_token& stop) {
        std::unique_lock lock(news->mutex);
        const auto passes_a_second = [&] {
            return !news->stopped.wait_for(lock, stop, std::chrono::seconds(1), [&] { return stop.stop_requested(); });
        };
        int seconds = 0;
        while (passes_a_second()) {
            fmt::print(stderr, "\r\033[K{} ({} s){}{}", activity, ++seconds, news->text.empty() ? "" : ": ",
                       news->text);
        }
        if (seconds > 0) fmt::print(stderr, "\r\033[K");
    });
}

void Progress::tell(std::string news) {
    const std::scoped_lock lock(news_->mutex);
    news_->text = std::move(news);
}

}  // namespace waybreaker::apps
