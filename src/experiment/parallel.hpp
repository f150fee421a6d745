// The same work on many items, over several threads.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace waybreaker::experiment {

// 0 stands for all cores.
inline unsigned thread_count(unsigned wanted) {
    return wanted > 0 ? wanted : std::max(1U, std::thread::hardware_concurrency());
}

// Calls work(i) for i = 0 .. count - 1, each once, in any order. Throws what one of the calls threw; items not begun by
// then are left out.
template <class Work>
void for_each_index(std::size_t count, unsigned threads, const Work& work) {
    std::atomic<std::size_t> next = 0;
    std::exception_ptr error;
    std::mutex error_mutex;
    const auto take = [&] {
        try {
            for (std::size_t i = next++; i < count; i = next++) work(i);
        } catch (...) {
            const std::scoped_lock lock(error_mutex);
            error = std::current_exception();
            next = count;
        }
    };
    {
        std::vector<std::jthread> others;
        for (std::size_t i = 1; i < std::min<std::size_t>(thread_count(threads), count); ++i) others.emplace_back(take);
        take();
    }
    if (error) std::rethrow_exception(error);
}

}  // namespace waybreaker::experiment
