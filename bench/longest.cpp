// Theta* on the last 100 scenarios (the longest) of Berlin_0_512, a set on which other Theta* programs are easily run.
//
//     bench_longest [REPEATS]
#include <cstdio>
#include <exception>
#include <fstream>

#include "maps.hpp"
#include "statistics.hpp"
#include "waybreaker/movingai.hpp"
#include "waybreaker/search.hpp"

namespace waybreaker::bench {
namespace {

void run(int repeats) {
    const std::filesystem::path file = shared_folder() / "data" / "cities" / "Berlin_0_512.map.scen";
    std::ifstream in(file, std::ios::binary);
    const std::vector<Scenario> scenarios = read_movingai_scenarios(in, file.string());
    const Map map(read_city("Berlin_0_512"));
    Searcher searcher;
    const std::size_t count = std::min<std::size_t>(100, scenarios.size());
    std::vector<double> seconds;
    std::vector<double> lengths;
    for (const Scenario& scenario : std::span(scenarios).last(count)) {
        SearchResult result;
        const auto search = [&] { result = searcher.find(OpenedMap(map), scenario.start, scenario.goal); };
        search();
        seconds.push_back(least_seconds(repeats, search));
        lengths.push_back(result.length);
    }
    std::printf("%zu scenarios, least of %d repeats, mean length %.3f\n", count, repeats, mean(lengths));
    print_header();
    print_milliseconds("Theta*", seconds);
}

}  // namespace
}  // namespace waybreaker::bench

int main(int argc, char** argv) {
    try {
        waybreaker::bench::run(argc > 1 ? std::stoi(argv[1]) : 5);
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "bench_longest: %s\n", error.what());
        return 1;
    }
}
