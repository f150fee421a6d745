// Every entry of every MovingAI scenario file of the shared folder, by A*, JPS and Dijkstra, against the octile length
// the file states. Fails if one is off by more than 1e-3 (5e-3 from 1000 on: most files give six digits).
//
//     bench_scenarios [EVERY]     // run one entry in EVERY
#include <array>
#include <cmath>
#include <cstdio>
#include <exception>
#include <fstream>

#include "maps.hpp"
#include "statistics.hpp"
#include "waybreaker/advanced/search.hpp"
#include "waybreaker/movingai.hpp"

namespace waybreaker::bench {
namespace {

struct Entrant {
    const char* name;
    Algorithm planner;
    double seconds = 0;
    std::size_t entries = 0;
    std::size_t wrong = 0;
};
using Entrants = std::array<Entrant, 3>;

void run_file(const std::filesystem::path& file, std::size_t every, Searcher& searcher, Entrants& entrants) {
    std::ifstream in(file, std::ios::binary);
    const std::vector<Scenario> scenarios = read_movingai_scenarios(in, file.string());
    if (scenarios.empty()) return;
    const std::filesystem::path map_file = file.parent_path() / std::filesystem::path(scenarios.front().map).filename();
    std::ifstream map_in(map_file, std::ios::binary);
    const Map map(read_movingai_map(map_in, map_file.string()));
    for (std::size_t i = 0; i < scenarios.size(); i += every) {
        const Scenario& scenario = scenarios[i];
        for (Entrant& entrant : entrants) {
            SearchResult result;
            entrant.seconds += seconds_of([&] {
                result = searcher.find(OpenedMap(map), scenario.start, scenario.goal, {.planner = entrant.planner});
            });
            ++entrant.entries;
            const double tolerance = scenario.optimal_length < 1000 ? 1e-3 : 5.001e-3;
            if (result.status == SearchStatus::found && std::abs(result.length - scenario.optimal_length) <= tolerance)
                continue;
            ++entrant.wrong;
            std::printf("%s, entry %zu, %s: %.6f instead of %.6f\n", file.filename().c_str(), i + 1, entrant.name,
                        result.length, scenario.optimal_length);
        }
    }
}

// How many searches went wrong.
std::size_t run(std::size_t every) {
    Entrants entrants{{{"A*", Algorithm::astar}, {"JPS", Algorithm::jps}, {"Dijkstra", Algorithm::dijkstra}}};
    Searcher searcher;
    std::size_t files = 0;
    for (const char* const folder : {"benchmarks", "cities"}) {
        for (const auto& entry : std::filesystem::directory_iterator(shared_folder() / "data" / folder)) {
            if (entry.path().extension() != ".scen") continue;
            run_file(entry.path(), every, searcher, entrants);
            ++files;
        }
    }
    std::size_t wrong = 0;
    std::printf("%zu scenario files, lengths as stated:", files);
    for (const Entrant& entrant : entrants) {
        std::printf("  %s %zu of %zu (%.3f ms each)", entrant.name, entrant.entries - entrant.wrong, entrant.entries,
                    1e3 * entrant.seconds / double(std::max<std::size_t>(entrant.entries, 1)));
        wrong += entrant.wrong;
    }
    std::printf("\n");
    return wrong;
}

}  // namespace
}  // namespace waybreaker::bench

int main(int argc, char** argv) {
    try {
        return waybreaker::bench::run(argc > 1 ? std::stoul(argv[1]) : 1) == 0 ? 0 : 1;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "bench_scenarios: %s\n", error.what());
        return 1;
    }
}
