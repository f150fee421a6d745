// Desk: runs the plans that clients ask for, and waits for them on the client's behalf.
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

class Desk {
  public:
    Desk(const Limits& limits, Metrics& metrics);

    // Throws Problem if too many wait.
    std::shared_ptr<Job> submit(Work work);
    // The work's result. Throws Problem if the client goes away, and what the work throws.
    Response wait_for(Job& job, const std::function<bool()>& client_is_there);
    // The same as server-sent events: `progress` from time to time, then `plan` or `problem`. `send` gives whether the
    // client is still there; if it is not, the work is stopped. What came of it: status 200 if nothing failed.
    Failure tell(Job& job, const std::function<bool(const std::string&)>& send);

    std::size_t waiting() const { return queue_.waiting(); }
    std::size_t running() const { return queue_.running(); }

  private:
    Failure give_up(Job& job);
    bool finish_in_time(Job& job, std::chrono::milliseconds time);

    Limits limits_;
    Metrics& metrics_;
    JobQueue queue_;
};

}  // namespace waybreaker::server
