#include "service/metrics.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace waybreaker::service {
namespace {

std::string heading(const std::string& name, const std::string& type, const std::string& help) {
    return fmt::format("# HELP {0} {2}\n# TYPE {0} {1}\n", name, type, help);
}

std::string single(const std::string& name, const std::string& type, const std::string& help, std::uint64_t value) {
    return heading(name, type, help) + fmt::format("{} {}\n", name, value);
}

}  // namespace

void Histogram::add(double seconds) {
    const auto bucket = std::lower_bound(bounds.begin(), bounds.end(), seconds) - bounds.begin();
    ++counts_[std::size_t(bucket)];
    sum_ += seconds;
}

std::string Histogram::text(const std::string& name, const std::string& labels) const {
    const std::string comma = labels.empty() ? "" : ",";
    const std::string braces = labels.empty() ? "" : "{" + labels + "}";
    std::string text;
    std::uint64_t count = 0;
    for (std::size_t i = 0; i < counts_.size(); ++i) {
        count += counts_[i];
        const std::string bound = i < bounds.size() ? fmt::format("{}", bounds[i]) : "+Inf";
        text += fmt::format("{}_bucket{{{}{}le=\"{}\"}} {}\n", name, labels, comma, bound, count);
    }
    return text + fmt::format("{0}_sum{1} {2}\n{0}_count{1} {3}\n", name, braces, sum_, count);
}

void Metrics::count_request(const std::string& method, const std::string& route, int status, double seconds) {
    const std::scoped_lock lock(mutex_);
    ++requests_[{method, route, status}];
    latency_[route].add(seconds);
}

void Metrics::count_plan(double seconds) {
    const std::scoped_lock lock(mutex_);
    plans_.add(seconds);
}

void Metrics::count_stopped() {
    const std::scoped_lock lock(mutex_);
    ++stopped_;
}

std::string Metrics::text(const Gauges& gauges) const {
    const std::scoped_lock lock(mutex_);
    std::string text = heading("waybreaker_requests_total", "counter", "Requests answered.");
    for (const auto& [key, count] : requests_) {
        const auto& [method, route, status] = key;
        text += fmt::format("waybreaker_requests_total{{method=\"{}\",route=\"{}\",status=\"{}\"}} {}\n", method, route,
                            status, count);
    }
    const std::string latency = "waybreaker_request_seconds";
    text += heading(latency, "histogram", "From the request's first line read to its answer made.");
    for (const auto& [route, histogram] : latency_) text += histogram.text(latency, "route=\"" + route + "\"");
    const std::string plans = "waybreaker_plan_seconds";
    text += heading(plans, "histogram", "Time of a planner at work on a request.") + plans_.text(plans, "");
    text += single("waybreaker_queue_length", "gauge", "Plans that wait for a worker.", gauges.plans.waiting);
    text += single("waybreaker_plans_running", "gauge", "Plans that workers are at.", gauges.plans.running);
    text += single("waybreaker_uploads_waiting", "gauge", "Maps sent or edited that wait.", gauges.uploads.waiting);
    text += single("waybreaker_uploads_running", "gauge", "Maps that are being made.", gauges.uploads.running);
    text +=
        single("waybreaker_imports_waiting", "gauge", "Imports, and map data sent, that wait.", gauges.imports.waiting);
    text +=
        single("waybreaker_imports_running", "gauge", "Imports, or map data read, at work.", gauges.imports.running);
    text += single("waybreaker_maps_loaded", "gauge", "Maps held in memory.", gauges.maps);
    text += single("waybreaker_maps_bytes", "gauge", "Memory that maps and map data take.", gauges.map_bytes);
    const Missions& missions = gauges.missions;
    if (missions.live) text += single("waybreaker_missions_live", "gauge", "Missions that are live.", *missions.live);
    text += single("waybreaker_missions_limit", "gauge", "The most missions that may be live.", missions.most);
    text += single("waybreaker_event_streams", "gauge", "Clients that listen to missions.", missions.streams);
    text += heading("waybreaker_reports_total", "counter", "Reports of live missions, by what came of them.");
    for (const auto& [status, count] : missions.reports) {
        text += fmt::format("waybreaker_reports_total{{status=\"{}\"}} {}\n", status, count);
    }
    text += heading("waybreaker_memory_bytes", "gauge", "Memory in use, of waybreaker_memory_limit_bytes.");
    for (const auto& [use, bytes] : gauges.memory) {
        text += fmt::format("waybreaker_memory_bytes{{use=\"{}\"}} {}\n", use, bytes);
    }
    text += single("waybreaker_memory_limit_bytes", "gauge", "The most memory that may be in use.", gauges.most_memory);
    text += single("waybreaker_refused_total", "counter", "Requests refused because too many waited.", gauges.refused);
    return text + single("waybreaker_stopped_total", "counter",
                         "Plans stopped because the client went away or time was up.", stopped_);
}

}  // namespace waybreaker::service
