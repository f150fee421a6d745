#include "service/executor.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

#include "http/client_address.hpp"
#include "http/problem.hpp"
#include "service/memory_account.hpp"

namespace waybreaker::service {
namespace {

constexpr double grace = 1;  // seconds beyond its own time limit after which a planner is stopped

}  // namespace

Executor::Executor(const ServiceLimits& limits, Metrics& metrics, MemoryBudget& budget)
    : limits_(limits),
      metrics_(metrics),
      budget_(budget),
      queues_{std::make_unique<http::JobQueue>(limits.workers, limits.queue),
              std::make_unique<http::JobQueue>(1, limits.queue), std::make_unique<http::JobQueue>(1, limits.queue)} {}

// Counts the memory of a job, and the time of a plan.
http::Work Executor::counted(http::Work work, Lane lane) const {
    return [this, work = std::move(work), lane](const http::Worker& worker) {
        MemoryAccount account(budget_, MemoryBudget::Use::job);
        const MemoryAccount::Scope scope(&account);
        const auto began = std::chrono::steady_clock::now();
        http::Response result = work(worker);
        const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - began;
        if (lane == Lane::planning) metrics_.count_plan(seconds.count());
        return result;
    };
}

std::shared_ptr<http::Job> Executor::submit(http::Work work, Lane lane, const std::string& client) {
    auto job = queues_[std::size_t(lane)]->submit(counted(std::move(work), lane), http::client_of(client));
    if (!job) throw http::Problem(http::unavailable, "too many others wait for the same; ask again in a moment");
    return job;
}

std::size_t Executor::refused() const {
    std::size_t sum = 0;
    for (const auto& queue : queues_) sum += queue->refused();
    return sum;
}

void Executor::enforce_time_limit(http::Job& job) {
    if (job.seconds() > std::min(limits_.seconds, job.time_limit()) + grace && job.stop()) metrics_.count_stopped();
}

void Executor::cancel(http::Job& job) {
    if (job.stop()) metrics_.count_stopped();
}

}  // namespace waybreaker::service
