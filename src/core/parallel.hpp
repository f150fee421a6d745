// The same work on many items, over several threads.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#ifndef WAYBREAKER_NO_THREADS
#include <mutex>
#include <system_error>
#include <thread>
#endif
#include <utility>
#include <vector>

namespace waybreaker {

#ifdef WAYBREAKER_NO_THREADS

// For a system without threads: the thread that calls does all the work.
inline unsigned thread_count(unsigned /*wanted*/) {
    return 1;
}

template <class Work>
void for_each_index(std::size_t count, unsigned /*threads*/, const Work& work) {
    for (std::size_t i = 0; i < count; ++i) work(i, 0);
}

// Calls `work` the first time that it is called.
class Once {
  public:
    template <class Work>
    void call(const Work& work) {
        if (!done_) work();
        done_ = true;
    }

  private:
    bool done_ = false;
};

#else

// 0 stands for all cores.
inline unsigned thread_count(unsigned wanted) {
    return wanted > 0 ? wanted : std::max(1U, std::thread::hardware_concurrency());
}

// Threads that are waited for, whatever happens: std::jthread, which not every standard library has.
class Joined {
  public:
    Joined() = default;
    Joined(const Joined&) = delete;
    Joined& operator=(const Joined&) = delete;
    ~Joined() {
        for (std::thread& thread : threads_) thread.join();
    }
    template <class Work>
    void start(Work work) {
        threads_.emplace_back(std::move(work));
    }

  private:
    std::vector<std::thread> threads_;
};

// Calls work(i, thread) for i = 0 .. count - 1, each once, in any order, on so many threads (0: all cores). They are
// numbered from 0, which is the one that calls; there are no more of them than items. Throws what one of the calls
// threw; items not begun by then are left out.
template <class Work>
void for_each_index(std::size_t count, unsigned threads, const Work& work) {
    std::atomic<std::size_t> next = 0;
    std::exception_ptr error;
    std::mutex error_mutex;
    const auto take = [&](std::size_t thread) {
        try {
            for (std::size_t i = next++; i < count; i = next++) work(i, thread);
        } catch (...) {
            const std::scoped_lock lock(error_mutex);
            error = std::current_exception();
            next = count;
        }
    };
    {
        Joined others;
        try {
            for (std::size_t thread = 1; thread < std::min<std::size_t>(thread_count(threads), count); ++thread) {
                others.start([&take, thread] { take(thread); });
            }
        } catch (const std::system_error&) {
            // The system has no more threads: fewer do the same.
        }
        take(0);
    }
    if (error) std::rethrow_exception(error);
}

// Calls `work` the first time that it is called, on whichever thread; all others wait.
class Once {
  public:
    template <class Work>
    void call(const Work& work) {
        std::call_once(flag_, work);
    }

  private:
    std::once_flag flag_;
};

#endif

}  // namespace waybreaker
