#include "service/plan_events.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "http/server_event.hpp"
#include "service/problem_kind.hpp"

namespace waybreaker::service {

void LastReport::set(const Progress& progress) {
    const std::scoped_lock lock(mutex_);
    progress_ = progress;
}

Progress LastReport::get() const {
    const std::scoped_lock lock(mutex_);
    return progress_;
}

std::string progress_event(const http::Job& job, const Progress& progress) {
    const auto [best, bound] = progress;
    const nlohmann::ordered_json json{
        {"state", job.state() == http::Job::State::queued ? "queued" : "planning"},
        {"seconds", job.seconds()},
        {"best", std::isfinite(best) ? nlohmann::ordered_json(best) : nlohmann::ordered_json()},
        {"bound", bound > 0 ? nlohmann::ordered_json(bound) : nlohmann::ordered_json()}};
    return http::server_event("progress", json.dump());
}

std::string plan_event(const http::Response& response) {
    return http::server_event("plan", response.body.bytes());
}

std::string problem_event(const Failure& failure) {
    return http::server_event("problem", problem_json(failure.status, failure.detail, failure.kind));
}

}  // namespace waybreaker::service
