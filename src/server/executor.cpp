#include "server/executor.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "server/client_address.hpp"
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
        return {unavailable, "out of memory", "", "no-memory"};
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

Executor::Executor(const ServiceLimits& limits, Metrics& metrics)
    : limits_(limits), metrics_(metrics), queue_(limits.workers, limits.queue) {}

std::shared_ptr<Job> Executor::submit(Work work, const std::string& client) {
    auto measured = [this, work = std::move(work)](const Worker& worker) {
        const auto began = std::chrono::steady_clock::now();
        Response result = work(worker);
        metrics_.count_plan(std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count());
        return result;
    };
    auto job = queue_.submit(std::move(measured), client_of(client));
    if (!job) throw Problem(unavailable, "too many plans are waiting; ask again in a moment");
    return job;
}

void Executor::enforce_time_limit(Job& job) {
    if (job.seconds() > std::min(limits_.seconds, job.time_limit()) + grace && job.stop()) metrics_.count_stopped();
}

void Executor::cancel(Job& job) {
    if (job.stop()) metrics_.count_stopped();
}

}  // namespace waybreaker::server
