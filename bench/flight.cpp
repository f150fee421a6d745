// The air agent's tour past the n obstacles most in the way: the shortest one, and the paper's.
#include "waybreaker/advanced/flight.hpp"

#include <benchmark/benchmark.h>

#include "maps.hpp"
#include "select/hits.hpp"
#include "waybreaker/advanced/search.hpp"

namespace waybreaker::bench {
namespace {

using Rule = Flight(const Map&, Point, Point, std::span<const ObstacleId>, const Airspace&);

void fly(benchmark::State& state, Rule* rule) {
    const Map map(read_city("Berlin_0_512"));
    const Cell start{236, 13};
    const Cell goal{388, 398};
    const SearchResult search = Searcher().find(OpenedMap(map), start, goal, {.count_hits = true});
    const std::vector<ObstacleId> chosen = most_hit(map, search.hits, int(state.range(0)));
    for (auto _ : state) benchmark::DoNotOptimize(rule(map, Point(start), Point(goal), chosen, {}));
    state.counters["length"] = rule(map, Point(start), Point(goal), chosen, {}).length;
}

BENCHMARK_CAPTURE(fly, optimal, fly_optimal)->DenseRange(1, 8)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(fly, nearest, fly_nearest)->DenseRange(1, 8)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace waybreaker::bench
