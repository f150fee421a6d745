// The paper's missions, whole: Theta* alone and the method from mission to plan, each time the least of some repeats.
//
//     bench_missions [--repeats N] [--against FILE.csv]
//
// FILE.csv holds another program's times of the same missions, taken on the same machine: columns map, start_x,
// start_y, goal_x, goal_y, time_stage1_seconds (its first search) and time_both_seconds (both searches). Pin both
// programs to the same core.
#include <cstdio>
#include <stdexcept>

#include "maps.hpp"
#include "missions_of_paper.hpp"
#include "program.hpp"
#include "statistics.hpp"
#include "waybreaker/advanced/search.hpp"
#include "waybreaker/error.hpp"
#include "waybreaker/planner.hpp"

namespace waybreaker::bench {
namespace {

struct Arguments {
    int repeats = 5;
    std::string against;
};

Arguments parse(std::span<char*> words) {
    Arguments arguments;
    for (std::size_t i = 1; i < words.size(); i += 2) {
        const std::string_view option = words[i];
        if (option == "--repeats" && i + 1 < words.size()) {
            arguments.repeats = std::stoi(words[i + 1]);
        } else if (option == "--against" && i + 1 < words.size()) {
            arguments.against = words[i + 1];
        } else {
            throw InputError("usage: bench_missions [--repeats N] [--against FILE.csv]");
        }
    }
    return arguments;
}

// Seconds, one entry a mission.
struct Times {
    std::vector<double> counting;  // Theta* counting hits, memory kept from query to query
    std::vector<double> plain;     // without counting
    std::vector<double> first;     // counting, the first query of a Searcher
    std::vector<double> whole;     // Planner::plan
};

void require_found(const SearchResult& result) {
    if (result.status != SearchStatus::found) throw std::runtime_error("a mission has no path");
}

Times measure(const std::vector<CityMission>& missions, int repeats) {
    const SearchOptions theta{.planner = Algorithm::theta};
    const SearchOptions counting{.planner = Algorithm::theta, .count_hits = true};
    Method paper;
    std::map<std::string, Map> cities;
    for (const CityMission& mission : missions) cities.try_emplace(mission.city, read_city(mission.city));
    Searcher searcher;
    Planner planner;
    Times times;
    for (const CityMission& mission : missions) {
        const Map& map = cities.at(mission.city);
        const auto search = [&](Searcher& with, const SearchOptions& options) {
            require_found(with.find(OpenedMap(map), mission.start, mission.goal, options));
        };
        Mission both = ground_and_air(mission.start, mission.goal);
        follow_paper(both.rules, paper);
        search(searcher, counting);  // brings map and nodes into the cache
        double with_hits = std::numeric_limits<double>::infinity();
        double without = with_hits;
        for (int i = 0; i < repeats; ++i) {  // in turns, so that both see the same disturbances
            with_hits = std::min(with_hits, seconds_of([&] { search(searcher, counting); }));
            without = std::min(without, seconds_of([&] { search(searcher, theta); }));
        }
        times.counting.push_back(with_hits);
        times.plain.push_back(without);
        times.first.push_back(least_seconds(repeats, [&] {
            Searcher fresh;
            search(fresh, counting);
        }));
        times.whole.push_back(least_seconds(repeats, [&] { planner.plan(map, both, paper); }));
    }
    return times;
}

void print_ratios(const std::string& file, const std::vector<CityMission>& missions, const Times& ours) {
    std::map<CityMission, const CsvRow*> row_of;
    const std::vector<CsvRow> rows = read_csv(file);
    for (const CsvRow& row : rows) row_of[mission_of(row)] = &row;
    std::vector<double> stage1;
    std::vector<double> both;
    for (const CityMission& mission : missions) {
        const CsvRow& row = *row_of.at(mission);
        stage1.push_back(std::stod(row.at("time_stage1_seconds")));
        both.push_back(std::stod(row.at("time_both_seconds")));
    }
    print_milliseconds("theirs: first search", stage1);
    print_milliseconds("theirs: both searches", both);
    std::printf("geometric mean of theirs / ours\n");
    std::printf("%-36s %8.2f\n", "first search, counting hits", mean_ratio(stage1, ours.counting));
    std::printf("%-36s %8.2f\n", "first search of a new Searcher", mean_ratio(stage1, ours.first));
    std::printf("%-36s %8.2f\n", "both searches / whole mission", mean_ratio(both, ours.whole));
}

void run(const Arguments& arguments) {
    const std::vector<CityMission> missions = missions_of_paper();
    const Times times = measure(missions, arguments.repeats);
    std::printf("%zu missions, least of %d repeats\n", missions.size(), arguments.repeats);
    print_header();
    print_milliseconds("Theta* counting hits", times.counting);
    print_milliseconds("Theta*", times.plain);
    print_milliseconds("Theta* counting hits, new Searcher", times.first);
    print_milliseconds("whole mission, n = 3", times.whole);
    std::printf("counting hits costs %.1f %% (geometric mean)\n", 100 * (mean_ratio(times.counting, times.plain) - 1));
    if (!arguments.against.empty()) print_ratios(arguments.against, missions, times);
}

}  // namespace
}  // namespace waybreaker::bench

int main(int argc, char** argv) {
    return waybreaker::bench::program("bench_missions", [&] {
        waybreaker::bench::run(waybreaker::bench::parse({argv, std::size_t(argc)}));
    });
}
