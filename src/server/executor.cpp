#include "server/executor.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "server/client_address.hpp"
#include "server/memory_account.hpp"
#include "server/problem.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::server {
namespace {

constexpr double grace = 1;  // seconds beyond its own time limit after which a planner is stopped

// An event in the format of the HTML standard; its data may have several lines.
std::string event(const std::string& name, std::string_view data) {
    std::string text = "event: " + name + "\n";
    for (std::size_t begin = 0; begin < data.size();) {
        const std::size_t end = std::min(data.find('\n', begin), data.size());
        text.append("data: ").append(data.substr(begin, end - begin)).append("\n");
        begin = end + 1;
    }
    return text + "\n";
}

std::string message_in_flight() {
    try {
        throw;
    } catch (const std::exception& error) {
        return error.what();
    } catch (...) {
        return "an exception that is none of ours";
    }
}

}  // namespace

Failure current_failure() {
    try {
        throw;
    } catch (const Problem& problem) {
        return {problem.status(), problem.what(), "", problem.kind()};
    } catch (const InputError& error) {
        return {unprocessable, error.what()};
    } catch (const std::bad_alloc&) {
        return {unavailable, "too little memory is left for this; ask again", "", "no-memory"};
    } catch (...) {
        return {internal_error, "this is our fault; the log says more", message_in_flight()};
    }
}

std::string progress_event(const Job& job) {
    const auto [best, bound] = job.progress();
    const nlohmann::ordered_json json{
        {"state", job.state() == Job::State::queued ? "queued" : "planning"},
        {"seconds", job.seconds()},
        {"best", std::isfinite(best) ? nlohmann::ordered_json(best) : nlohmann::ordered_json()},
        {"bound", bound > 0 ? nlohmann::ordered_json(bound) : nlohmann::ordered_json()}};
    return event("progress", json.dump());
}

std::string plan_event(const Response& response) {
    return event("plan", response.body.bytes());
}

std::string problem_event(const Failure& failure) {
    return event("problem", problem_json(failure.status, failure.detail, failure.kind));
}

Executor::Executor(const ServiceLimits& limits, Metrics& metrics, MemoryBudget& budget)
    : limits_(limits),
      metrics_(metrics),
      budget_(budget),
      queues_{std::make_unique<JobQueue>(limits.workers, limits.queue), std::make_unique<JobQueue>(1, limits.queue),
              std::make_unique<JobQueue>(1, limits.queue)} {}

// Counts the memory of a job, and the time of a plan.
Work Executor::counted(Work work, Lane lane) const {
    return [this, work = std::move(work), lane](const Worker& worker) {
        MemoryAccount account(budget_, MemoryBudget::Use::job);
        const MemoryAccount::Scope scope(&account);
        const auto began = std::chrono::steady_clock::now();
        Response result = work(worker);
        const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - began;
        if (lane == Lane::planning) metrics_.count_plan(seconds.count());
        return result;
    };
}

std::shared_ptr<Job> Executor::submit(Work work, Lane lane, const std::string& client) {
    auto job = queues_[std::size_t(lane)]->submit(counted(std::move(work), lane), client_of(client));
    if (!job) throw Problem(unavailable, "too many others wait for the same; ask again in a moment");
    return job;
}

std::size_t Executor::refused() const {
    std::size_t sum = 0;
    for (const auto& queue : queues_) sum += queue->refused();
    return sum;
}

void Executor::enforce_time_limit(Job& job) {
    if (job.seconds() > std::min(limits_.seconds, job.time_limit()) + grace && job.stop()) metrics_.count_stopped();
}

void Executor::cancel(Job& job) {
    if (job.stop()) metrics_.count_stopped();
}

}  // namespace waybreaker::server
