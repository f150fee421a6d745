// Executor: runs the work that clients request, and reports its progress.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "server/job_queue.hpp"
#include "server/limits.hpp"
#include "server/metrics.hpp"

namespace waybreaker::server {

// What a client learns of the exception being handled.
struct Failure {
    int status;
    std::string detail;
    std::string cause = {};      // for the log, where the client must not see it
    std::string_view kind = {};  // of the problem; empty: the default of its status
};
Failure current_failure();

// Server-sent events: the progress of a job, and its result.
std::string progress_event(const Job& job);
std::string plan_event(const Response& response);
std::string problem_event(const Failure& failure);

class Executor {
  public:
    Executor(const ServiceLimits& limits, Metrics& metrics);

    // Throws Problem if the queue is full. `client`: the address of who asks.
    std::shared_ptr<Job> submit(Work work, const std::string& client);
    // Stops the job if it takes too long. To be called from time to time until the job is done.
    void enforce_time_limit(Job& job);
    // The result is no longer needed.
    void cancel(Job& job);

    std::size_t waiting() const { return queue_.waiting(); }
    std::size_t running() const { return queue_.running(); }
    std::size_t refused() const { return queue_.refused(); }

  private:
    ServiceLimits limits_;
    Metrics& metrics_;
    JobQueue queue_;
};

}  // namespace waybreaker::server
