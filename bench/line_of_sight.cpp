// One line-of-sight test on a city map, by the length of the segment. Theta* mostly tests clear segments, so
// those are timed apart from random ones.
#include "map/line_of_sight.hpp"

#include <benchmark/benchmark.h>

#include <numbers>
#include <random>

#include "maps.hpp"

namespace waybreaker::bench {
namespace {

struct Segment {
    Cell from;
    Cell to;
};

// Segments of about one length between free cells, in all directions; the same ones in every run.
std::vector<Segment> segments(const LineOfSight& sight, const Map& map, double length, bool only_clear) {
    std::mt19937 random(1);
    std::vector<Segment> result;
    while (result.size() < 4096) {
        const double angle = 2 * std::numbers::pi * double(random()) / double(std::mt19937::max());
        const Cell from{int(random() % unsigned(map.width())), int(random() % unsigned(map.height()))};
        const Cell to{from.x + int(std::lround(length * std::cos(angle))),
                      from.y + int(std::lround(length * std::sin(angle)))};
        if (!map.grid().contains(to) || !sight.fits(from) || !sight.fits(to)) continue;
        if (!only_clear || sight.clear(from, to)) result.push_back({from, to});
    }
    return result;
}

void line_of_sight(benchmark::State& state, bool only_clear, double radius) {
    const Map map(read_city("Berlin_0_512"));
    const OpenedMap opened(map);
    const LineOfSight sight(opened, {.radius = radius});
    const std::vector<Segment> tests = segments(sight, map, double(state.range(0)), only_clear);
    std::size_t next = 0;
    for (auto _ : state) {
        const Segment& segment = tests[next++ % tests.size()];
        benchmark::DoNotOptimize(sight.clear(segment.from, segment.to));
    }
}

BENCHMARK_CAPTURE(line_of_sight, clear, true, 0.5)->Arg(1)->Arg(4)->Arg(16)->Arg(64);
BENCHMARK_CAPTURE(line_of_sight, random, false, 0.5)->Arg(4)->Arg(16)->Arg(64)->Arg(256);
BENCHMARK_CAPTURE(line_of_sight, wide_agent_clear, true, 1.5)->Arg(4)->Arg(16)->Arg(64);

}  // namespace
}  // namespace waybreaker::bench
