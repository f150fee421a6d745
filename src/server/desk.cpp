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
std::string event(const std::string& name, const std::string& data) {
    std::string text = "event: " + name + "\n";
    for (std::size_t begin = 0; begin < data.size();) {
        const std::size_t end = std::min(data.find('\n', begin), data.size());
        text += "data: " + data.substr(begin, end - begin) + "\n";
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
        return {problem.status(), problem.what()};
    } catch (const InputError& error) {
        return {unprocessable, error.what()};
    } catch (const std::bad_alloc&) {
        return {unavailable, "out of memory"};
    } catch (...) {
        return {internal_error, "this is our fault; the log says more", message_in_flight()};
    }
}

Desk::Desk(const Limits& limits, Metrics& metrics)
    : limits_(limits), metrics_(metrics), queue_(limits.workers, limits.queue) {}

std::shared_ptr<Job> Desk::submit(Work work) {
    auto job = queue_.submit([this, work = std::move(work)](const Workplace& place) {
        const auto began = std::chrono::steady_clock::now();
        std::string result = work(place);
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

std::string Desk::wait_for(Work work, const std::function<bool()>& client_is_there) {
    const std::shared_ptr<Job> job = submit(std::move(work));
    while (!finish_in_time(*job, between_events)) {
        if (client_is_there()) continue;
        if (job->stop()) metrics_.count_stopped();
        throw Problem(client_gone, "the client went away");
    }
    return job->result();
}

void Desk::stream(Work work, httplib::Response& response, Ended ended) {
    const std::shared_ptr<Job> job = submit(std::move(work));
    const auto finished = std::make_shared<bool>(false);
    const auto tell = [this, job, ended, finished](std::size_t, httplib::DataSink& sink) {
        const auto send = [&sink](const std::string& text) {
            return sink.is_writable() && sink.write(text.data(), text.size());
        };
        bool there = send(progress(*job));
        while (there && !finish_in_time(*job, between_events)) there = send(progress(*job));
        if (!there) return false;
        Failure outcome{ok, ""};
        try {
            send(event("plan", job->result()));
        } catch (...) {
            outcome = current_failure();
            send(event("problem", problem_json(outcome.status, outcome.detail)));
        }
        *finished = true;
        ended(outcome);
        sink.done();
        return true;
    };
    const auto left = [this, job, ended, finished](bool) {
        if (*finished) return;
        if (job->stop()) metrics_.count_stopped();
        ended({client_gone, "the client went away"});
    };
    response.set_chunked_content_provider("text/event-stream", tell, left);
}

}  // namespace waybreaker::server
