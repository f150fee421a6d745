// Opening a map: with nothing removed, with obstacles of usual size removed, with the largest one removed.
#include <benchmark/benchmark.h>

#include <algorithm>

#include "maps.hpp"
#include "waybreaker/map.hpp"

namespace waybreaker::bench {
namespace {

// The ids of the obstacles from the largest to the smallest.
std::vector<ObstacleId> by_size(const Map& map) {
    std::vector<Obstacle> obstacles(map.obstacles().begin(), map.obstacles().end());
    std::sort(obstacles.begin(), obstacles.end(),
              [](const Obstacle& a, const Obstacle& b) { return a.cells > b.cells; });
    std::vector<ObstacleId> ids;
    for (const Obstacle& obstacle : obstacles) ids.push_back(obstacle.id);
    return ids;
}

void open_map(benchmark::State& state, std::size_t removals, bool largest) {
    const Map map(mosaic(read_city("Berlin_0_512"), int(state.range(0))));
    std::vector<ObstacleId> ids = by_size(map);
    if (!largest) ids.erase(ids.begin(), ids.begin() + std::ssize(ids) / 4);
    ids.resize(removals);
    for (auto _ : state) benchmark::DoNotOptimize(OpenedMap(map, ids));
}

BENCHMARK_CAPTURE(open_map, nothing, 0, false)->Arg(512)->Arg(4096);
BENCHMARK_CAPTURE(open_map, 3_of_upper_quartile, 3, false)->Arg(512)->Arg(4096);
BENCHMARK_CAPTURE(open_map, largest, 1, true)->Arg(512)->Arg(4096);

}  // namespace
}  // namespace waybreaker::bench
