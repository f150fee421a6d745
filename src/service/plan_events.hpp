// Events of a plan: its progress, and its result, for clients that wait for it.
#pragma once

#include <mutex>
#include <string>

#include "http/job_queue.hpp"
#include "http/message.hpp"
#include "service/failure.hpp"
#include "waybreaker/limits.hpp"

namespace waybreaker::service {

// What a planner has reported last. Thread-safe.
class LastReport {
  public:
    void set(const Progress& progress);
    Progress get() const;

  private:
    mutable std::mutex mutex_;
    Progress progress_;
};

std::string progress_event(const http::Job& job, const Progress& progress);
std::string plan_event(const http::Response& response);
std::string problem_event(const Failure& failure);

}  // namespace waybreaker::service
