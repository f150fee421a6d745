// Executor: runs the work that clients request, and reports its progress.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "server/job_queue.hpp"
#include "server/limits.hpp"
#include "server/memory_budget.hpp"
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

// Work of each kind has workers and a queue of its own, so that none waits for another: plans, and what else is asked
// of a map; maps that are sent or edited; map data, and imports from it.
enum class Lane { planning, uploading, importing };

class Executor {
  public:
    // Keeps the references.
    Executor(const ServiceLimits& limits, Metrics& metrics, MemoryBudget& budget);

    // Throws Problem if the lane's queue is full. `client`: the address of who asks.
    std::shared_ptr<Job> submit(Work work, Lane lane, const std::string& client);
    // Stops the job if it takes too long. To be called from time to time until the job is done.
    void enforce_time_limit(Job& job);
    // The result is no longer needed.
    void cancel(Job& job);

    const JobQueue& queue(Lane lane) const { return *queues_[std::size_t(lane)]; }
    // Jobs of all lanes for which there was no room.
    std::size_t refused() const;

  private:
    Work counted(Work work, Lane lane) const;

    ServiceLimits limits_;
    Metrics& metrics_;
    MemoryBudget& budget_;
    std::array<std::unique_ptr<JobQueue>, 3> queues_;
};

}  // namespace waybreaker::server
