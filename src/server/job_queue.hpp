// Job queue: a few workers, each with a planner that keeps its memory, and a short line in front of them.
//
//     JobQueue queue(2, 16);
//     const auto job = queue.submit([&](const Workplace& place) { return place.planner...; });
//     if (!job) ...;                            // the line is full
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
#include "waybreaker/planner.hpp"

namespace waybreaker::server {

// What work is done with.
struct Workplace {
    MissionPlanner& planner;
    StopToken stop;
    std::function<void(const Progress&)> tell;    // how far it is
    std::function<void(double seconds)> promise;  // in how long it will be done, counted from its begin
};

// Makes the answer to a request.
using Work = std::function<Response(const Workplace&)>;

class Job {
  public:
    enum class State { queued, running, done };

    explicit Job(Work work) : work_(std::move(work)) {}

    State state() const;
    double seconds() const;  // since it began
    Progress progress() const;
    double promised() const;  // seconds from its begin; infinity if nothing is
    // Calls that when the job is done, on the worker's thread, or at once if it is done already.
    void when_done(std::function<void()> call);
    // Work that has not begun never does; the rest is asked to end.
    // Whether this is the first time.
    bool stop() { return stop_.request_stop(); }
    // What the work gave back, or throws what it threw. Precondition: done.
    Response result();

  private:
    friend class JobQueue;
    void run(MissionPlanner& planner);
    void finish();

    Work work_;
    StopSource stop_;
    mutable std::mutex mutex_;
    State state_ = State::queued;
    std::chrono::steady_clock::time_point began_;
    Progress progress_;
    double promised_ = std::numeric_limits<double>::infinity();
    Response result_;
    std::exception_ptr failure_;
    std::function<void()> when_done_;
};

class JobQueue {
  public:
    JobQueue(unsigned workers, std::size_t waiting_limit);
    // Stops what runs and waits for it.
    ~JobQueue();

    // Empty if no more may wait.
    std::shared_ptr<Job> submit(Work work);
    std::size_t waiting() const;
    std::size_t running() const;

  private:
    void serve(const std::stop_token& stop);

    std::size_t waiting_limit_;
    mutable std::mutex mutex_;
    std::condition_variable_any ready_;
    std::deque<std::shared_ptr<Job>> line_;
    std::vector<std::shared_ptr<Job>> running_;
    std::vector<std::jthread> workers_;
};

}  // namespace waybreaker::server
