// Job queue: a few worker threads and a bounded queue.
//
//     JobQueue queue(2, 16);
//     const auto job = queue.submit([&](const Worker& worker) { return answer_until(worker.stop); });
//     if (!job) ...;                            // the queue is full
//     job->when_done([job] { answer(job->result()); });    // or job->stop()
#pragma once

#include <chrono>
#include <condition_variable>
#include <deque>
#include <exception>
#include <functional>
#include <limits>
#include <memory>
#include <mutex>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include "server/message.hpp"
#include "waybreaker/limits.hpp"

namespace waybreaker::server {

// What a job gets from the thread that runs it.
struct Worker {
    StopToken stop;
    std::function<void(const Progress&)> report;
    std::function<void(double seconds)> set_time_limit;  // from the start of the job
};

// Makes the response to a request.
using Work = std::function<Response(const Worker&)>;

class Job {
  public:
    enum class State { queued, running, done };

    explicit Job(Work work) : work_(std::move(work)) {}

    State state() const;
    double seconds() const;  // since it started; 0 while queued
    Progress progress() const;
    double time_limit() const;  // seconds from its start; infinity if none is set
    // Calls `call` when the job is done, on the worker's thread; at once if it is done already.
    void when_done(std::function<void()> call);
    // Queued work never starts; running work is asked to stop. Whether this is the first call.
    bool stop() { return stop_.request_stop(); }
    // What the work returned; throws what it threw. Precondition: done.
    Response result();

  private:
    friend class JobQueue;
    void run();
    void finish();

    Work work_;
    StopSource stop_;
    mutable std::mutex mutex_;
    State state_ = State::queued;
    std::chrono::steady_clock::time_point began_;
    Progress progress_;
    double time_limit_ = std::numeric_limits<double>::infinity();
    Response result_;
    std::exception_ptr failure_;
    std::function<void()> when_done_;
};

class JobQueue {
  public:
    JobQueue(unsigned workers, std::size_t waiting_limit);
    // Stops running jobs and waits for them.
    ~JobQueue();

    // Null if the queue is full.
    std::shared_ptr<Job> submit(Work work);
    std::size_t waiting() const;
    std::size_t running() const;

  private:
    void serve(const std::stop_token& stop);

    std::size_t waiting_limit_;
    mutable std::mutex mutex_;
    std::condition_variable_any ready_;
    std::deque<std::shared_ptr<Job>> queue_;
    std::vector<std::shared_ptr<Job>> running_;
    std::vector<std::jthread> workers_;
};

}  // namespace waybreaker::server
