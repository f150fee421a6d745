// Executor: runs the work that clients request, within the limits.
#pragma once

#include <array>
#include <memory>
#include <string>

#include "http/job_queue.hpp"
#include "service/limits.hpp"
#include "service/memory_budget.hpp"
#include "service/metrics.hpp"

namespace waybreaker::service {

// Work of each kind has workers and a queue of its own, so that none waits for another: plans, and what else is asked
// of a map; maps that are sent or edited; map data, and imports from it.
enum class Lane { planning, uploading, importing };

class Executor {
  public:
    // Keeps the references.
    Executor(const ServiceLimits& limits, Metrics& metrics, MemoryBudget& budget);

    // Throws Problem if the lane's queue is full. `client`: the address of who asks.
    std::shared_ptr<http::Job> submit(http::Work work, Lane lane, const std::string& client);
    // Stops the job if it takes too long. To be called from time to time until the job is done.
    void enforce_time_limit(http::Job& job);
    // The result is no longer needed.
    void cancel(http::Job& job);

    const http::JobQueue& queue(Lane lane) const { return *queues_[std::size_t(lane)]; }
    // Jobs of all lanes for which there was no room.
    std::size_t refused() const;

  private:
    http::Work counted(http::Work work, Lane lane) const;

    ServiceLimits limits_;
    Metrics& metrics_;
    MemoryBudget& budget_;
    std::array<std::unique_ptr<http::JobQueue>, 3> queues_;
};

}  // namespace waybreaker::service
