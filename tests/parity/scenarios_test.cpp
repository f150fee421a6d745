// The MovingAI scenarios' octile lengths (column 9), on a sample; bench/scenarios.cpp runs all of them.
#include <gtest/gtest.h>

#include <fstream>
#include <iostream>

#include "shared_data.hpp"
#include "waybreaker/advanced/search.hpp"
#include "waybreaker/movingai.hpp"

namespace waybreaker {
namespace {

namespace fs = std::filesystem;

// `every`: one of so many entries is run; of these one in five by Dijkstra too.
int run_sample(const fs::path& folder, std::size_t every) {
    Searcher searcher;
    int searches = 0;
    for (const fs::path& file : files_of(folder, ".scen")) {
        std::ifstream in(file, std::ios::binary);
        const std::vector<Scenario> scenarios = read_movingai_scenarios(in, file.string());
        EXPECT_FALSE(scenarios.empty()) << file;
        const fs::path map_file = folder / fs::path(scenarios.front().map).filename();
        std::ifstream map_in(map_file, std::ios::binary);
        const Map map(read_movingai_map(map_in, map_file.string()));
        for (std::size_t i = every - 1; i < scenarios.size(); i += every) {
            const Scenario& scenario = scenarios[i];
            for (const Algorithm planner : {Algorithm::jps, Algorithm::astar, Algorithm::dijkstra}) {
                if (planner == Algorithm::dijkstra && i / every % 5 != 0) continue;
                const SearchResult result =
                    searcher.find(OpenedMap(map), scenario.start, scenario.goal, {.planner = planner});
                EXPECT_EQ(result.status, SearchStatus::found) << file << " entry " << i + 1;
                // Most files give six digits, which from 1000 on are hundredths.
                const double tolerance = scenario.optimal_length < 1000 ? 1e-3 : 5.001e-3;
                EXPECT_NEAR(result.length, scenario.optimal_length, tolerance) << file << " entry " << i + 1;
                ++searches;
            }
        }
    }
    return searches;
}

TEST(Scenarios, AreSolvedAtTheirLength) {
    const auto shared = shared_folder();
    if (!shared) GTEST_SKIP() << no_shared_folder;
    const int searches =
        run_sample(*shared / "data" / "benchmarks", 100) + run_sample(*shared / "data" / "cities", 100);
    std::cout << searches << " searches\n";
    EXPECT_GT(searches, 1000);
}

}  // namespace
}  // namespace waybreaker
