// Runs the benchmarks of single parts; options are Google Benchmark's.
#include <benchmark/benchmark.h>

#include "program.hpp"

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
    return waybreaker::bench::program("bench_parts", [] { benchmark::RunSpecifiedBenchmarks(); });
}
