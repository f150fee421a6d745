// One long query on a city map with every planner, and Theta* with its hit counting on and off.
#include "waybreaker/advanced/search.hpp"

#include <benchmark/benchmark.h>

#include "maps.hpp"

namespace waybreaker::bench {
namespace {

void find(benchmark::State& state, const SearchOptions& options) {
    const Map map(read_city("Berlin_0_512"));
    Searcher searcher;
    std::uint64_t expanded = 0;
    for (auto _ : state) {
        const SearchResult result = searcher.find(OpenedMap(map), {236, 13}, {388, 398}, options);
        if (result.status != SearchStatus::found) state.SkipWithError("no path");
        expanded = result.expanded;
    }
    state.counters["expanded"] = double(expanded);
    state.counters["per_expansion"] = benchmark::Counter(
        double(expanded), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

BENCHMARK_CAPTURE(find, theta, {.planner = Algorithm::theta})->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(find, theta_counting_hits, {.planner = Algorithm::theta, .count_hits = true})
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(find, theta_weight_2, {.planner = Algorithm::theta, .weight = 2})->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(find, lazy_theta, {.planner = Algorithm::lazy_theta})->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(find, astar, {.planner = Algorithm::astar})->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(find, jps, {.planner = Algorithm::jps})->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(find, dijkstra, {.planner = Algorithm::dijkstra})->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(find, bfs, {.planner = Algorithm::bfs})->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(find, theta_wide_agent, {.planner = Algorithm::theta, .body = {.radius = 1.5}})
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace waybreaker::bench
