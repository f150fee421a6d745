// Job queue: a few worker threads, and a bounded queue in which clients take turns.
//
//     JobQueue queue(2, 16);
//     const auto job = queue.submit([&](const Worker& worker) { return answer_until(worker.stop); }, "192.0.2.7");
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

#include "http/message.hpp"
#include "waybreaker/limits.hpp"

namespace waybreaker::http {

// What a job gets from the thread that runs it.
struct Worker {
    StopToken stop;
    std::function<void(double seconds)> set_time_limit;  // from the start of the job
};

// Makes the response to a request.
using Work = std::function<Response(const Worker&)>;

class Job {
  public:
    enum class State { queued, running, done };

    explicit Job(Work work) : work_(std::move(work)) {}

    State state() const;
    double seconds() const;     // since it started; 0 while queued
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
    void displace();
    void finish();

    Work work_;
    StopSource stop_;
    mutable std::mutex mutex_;
    State state_ = State::queued;
    std::chrono::steady_clock::time_point began_;
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

    // Null if the queue is full. Workers take one job of each client after the other, and where a client has fewer jobs
    // in a full queue than another, the newest one of the client that has most makes room: its result is a Problem.
    std::shared_ptr<Job> submit(Work work, const std::string& client = "");
    std::size_t waiting() const;
    std::size_t running() const;
    std::size_t refused() const;  // jobs for which there was no room

  private:
    struct Line {
        std::string client;
        std::deque<std::shared_ptr<Job>> jobs;  // never empty
    };
    void serve(const std::stop_token& stop);
    // With mutex_ locked:
    void forget_stopped();
    std::size_t waiting_jobs() const;
    std::shared_ptr<Job> make_room(const std::string& client);
    std::shared_ptr<Job> take_next();

    std::size_t waiting_limit_;
    mutable std::mutex mutex_;
    std::condition_variable_any ready_;
    std::deque<Line> lines_;  // whose turn it is comes first
    std::size_t refused_ = 0;
    std::vector<std::shared_ptr<Job>> running_;
    std::vector<std::jthread> workers_;
};

}  // namespace waybreaker::http
