#include "server/desk.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "server/problem.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::server {
namespace {

using std::chrono::milliseconds;
constexpr milliseconds between_events(250);
constexpr double grace = 1;  // seconds that a planner has to keep its own time limit

// An event of several lines, as the HTML standard writes it.
std::string event(const std::string& name, std::string_view data) {
    std::string text = "event: " + name + "\n";
    for (std::size_t begin = 0; begin < data.size();) {
        const std::size_t end = std::min(data.find('\n', begin), data.size());
        text.append("data: ").append(data.substr(begin, end - begin)).append("\n");
        begin = end + 1;
    }
    return text + "\n";
}

std::string progress(const Job& job) {
    using Json = nlohmann::ordered_json;
    const auto [best, bound] = job.progress();
    const Json json{{"state", job.state() == Job::State::queued ? "queued" : "planning"},
                    {"seconds", job.seconds()},
                    {"best", std::isfinite(best) ? Json(best) : Json()},
                    {"bound", bound > 0 ? Json(bound) : Json()}};
    return event("progress", json.dump());
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

Desk::Desk(const Limits& limits, Metrics& metrics)
    : limits_(limits), metrics_(metrics), queue_(limits.workers, limits.queue) {}

std::shared_ptr<Job> Desk::submit(Work work) {
    auto job = queue_.submit([this, work = std::move(work)](const Workplace& place) {
        const auto began = std::chrono::steady_clock::now();
        Response result = work(place);
        metrics_.count_plan(std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count());
        return result;
    });
    if (!job) {
        metrics_.count_refused();
        throw Problem(unavailable, "too many plans are waiting; ask again in a moment");
    }
    return job;
}

// Whether the job is done by then; one that takes too long is stopped.
bool Desk::finish_in_time(Job& job, milliseconds time) {
    if (job.wait(time)) return true;
    if (job.seconds() > limits_.seconds + grace && job.stop()) metrics_.count_stopped();
    return false;
}

Failure Desk::give_up(Job& job) {
    if (job.stop()) metrics_.count_stopped();
    return {client_gone, "the client went away"};
}

Response Desk::wait_for(Job& job, const std::function<bool()>& client_is_there) {
    while (!finish_in_time(job, between_events)) {
        if (!client_is_there()) throw Problem(client_gone, give_up(job).detail);
    }
    return job.result();
}

Failure Desk::tell(Job& job, const std::function<bool(const std::string&)>& send) {
    do {
        if (!send(progress(job))) return give_up(job);
    } while (!finish_in_time(job, between_events));
    try {
        const Response response = job.result();
        if (!send(event("plan", response.body.bytes()))) return give_up(job);
        return {ok, ""};
    } catch (...) {
        const Failure failure = current_failure();
        send(event("problem", problem_json(failure.status, failure.detail, failure.kind)));
        return failure;
    }
}

}  // namespace waybreaker::server
