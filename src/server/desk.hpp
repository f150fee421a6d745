// Desk: has the plans made that clients ask for, and tells how far they are.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "server/job_queue.hpp"
#include "server/limits.hpp"
#include "server/metrics.hpp"

namespace waybreaker::server {

// What an exception that is in flight means to a client.
struct Failure {
    int status;
    std::string detail;
    std::string cause = {};      // where that must not be told: for the log
    std::string_view kind = {};  // of the problem, if it is not the usual one of its status
};
Failure current_failure();

// Server-sent events: how far a job is, and what has come of it.
std::string progress_event(const Job& job);
std::string plan_event(const Response& response);
std::string problem_event(const Failure& failure);

class Desk {
  public:
    Desk(const ServiceLimits& limits, Metrics& metrics);

    // Throws Problem if too many wait.
    std::shared_ptr<Job> submit(Work work);
    // To be called from time to time while the job is not done: one that takes too long is stopped.
    void watch(Job& job);
    // Nobody wants its result any more.
    void give_up(Job& job);

    std::size_t waiting() const { return queue_.waiting(); }
    std::size_t running() const { return queue_.running(); }

  private:
    ServiceLimits limits_;
    Metrics& metrics_;
    JobQueue queue_;
};

}  // namespace waybreaker::server
