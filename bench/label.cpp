// Labelling a city mosaic, and what else making a Map takes. items_per_second is cells a second.
#include "map/label.hpp"

#include <benchmark/benchmark.h>

#include "maps.hpp"

namespace waybreaker::bench {
namespace {

Grid city_mosaic(const benchmark::State& state) {
    return mosaic(read_city("Berlin_0_512"), int(state.range(0)));
}

void count_cells(benchmark::State& state) {
    state.SetItemsProcessed(state.iterations() * state.range(0) * state.range(0));
}

void label(benchmark::State& state, Connectivity connectivity) {
    const Grid grid = city_mosaic(state);
    for (auto _ : state) benchmark::DoNotOptimize(label_components(grid, connectivity));
    count_cells(state);
}

void transpose(benchmark::State& state) {
    const Grid grid = city_mosaic(state);
    for (auto _ : state) benchmark::DoNotOptimize(grid.transposed());
    count_cells(state);
}

void make_map(benchmark::State& state) {
    const Grid grid = city_mosaic(state);
    for (auto _ : state) benchmark::DoNotOptimize(Map(grid));
    count_cells(state);
}

BENCHMARK_CAPTURE(label, 4_connected, Connectivity::four)->Arg(512)->Arg(4096)->Arg(16384);
BENCHMARK_CAPTURE(label, 8_connected, Connectivity::eight)->Arg(4096);
BENCHMARK(transpose)->Arg(512)->Arg(16384);
BENCHMARK(make_map)->Arg(512)->Arg(4096)->Arg(16384);

}  // namespace
}  // namespace waybreaker::bench
