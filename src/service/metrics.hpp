// Metrics: what the server has done, in the text format of Prometheus.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace waybreaker::service {

// Counts of durations, and their sum. Bounds are inclusive, in seconds.
class Histogram {
  public:
    static constexpr std::array<double, 12> bounds{0.001, 0.0025, 0.005, 0.01, 0.025, 0.05, 0.1, 0.25, 0.5, 1, 5, 30};
    void add(double seconds);
    // Lines of the series NAME_bucket, NAME_sum, NAME_count; `labels` is 'route="..."' or empty.
    std::string text(const std::string& name, const std::string& labels) const;

  private:
    std::array<std::uint64_t, bounds.size() + 1> counts_{};
    double sum_ = 0;
};

class Metrics {
  public:
    // `route` is a route's path, never the client's input.
    void count_request(const std::string& method, const std::string& route, int status, double seconds);
    void count_plan(double seconds);
    void count_stopped();  // the client disconnected, or the time limit was reached

    struct Lane {
        std::size_t waiting = 0;
        std::size_t running = 0;
    };
    struct Missions {
        std::optional<std::size_t> live = {};  // empty: the store does not say
        std::size_t most = 0;
        std::size_t streams = 0;                            // of events, to clients that listen
        std::map<std::string, std::uint64_t> reports = {};  // since the start, by what came of them
    };
    struct Gauges {
        Lane plans = {};
        Lane uploads = {};
        Lane imports = {};
        std::size_t refused = 0;  // since the start: for want of room in a queue
        std::size_t maps = 0;
        Missions missions = {};
        std::size_t map_bytes = 0;
        std::vector<std::pair<std::string, std::size_t>> memory = {};  // by what it is used for
        std::size_t most_memory = 0;
    };
    std::string text(const Gauges& gauges) const;

  private:
    mutable std::mutex mutex_;
    std::map<std::tuple<std::string, std::string, int>, std::uint64_t> requests_;
    std::map<std::string, Histogram> latency_;
    Histogram plans_;
    std::uint64_t stopped_ = 0;
};

}  // namespace waybreaker::service
