// Desk: runs the plans that clients ask for, and waits for them on the client's behalf.
#pragma once

#include <httplib.h>

#include <functional>
#include <memory>
#include <string>

#include "server/job_queue.hpp"
#include "server/limits.hpp"
#include "server/metrics.hpp"

namespace waybreaker::server {

// What an exception that is in flight means to a client.
struct Failure {
    int status;
    std::string detail;
    std::string cause = {};  // where that must not be told: for the log
};
Failure current_failure();

// Told once, when a streamed answer is over: with status 200 if nothing failed.
using Ended = std::function<void(const Failure& outcome)>;

class Desk {
  public:
    Desk(const Limits& limits, Metrics& metrics);

    // The work's result. Throws Problem if too many wait or the client goes away, and what the work throws.
    std::string wait_for(Work work, const std::function<bool()>& client_is_there);

    // The same as server-sent events: `progress` from time to time, then `plan` or `problem`. If the client goes away,
    // the work is stopped. Throws Problem if too many wait.
    void stream(Work work, httplib::Response& response, Ended ended);

    std::size_t waiting() const { return queue_.waiting(); }
    std::size_t running() const { return queue_.running(); }

  private:
    std::shared_ptr<Job> submit(Work work);
    bool finish_in_time(Job& job, std::chrono::milliseconds time);

    Limits limits_;
    Metrics& metrics_;
    JobQueue queue_;
};

}  // namespace waybreaker::server
