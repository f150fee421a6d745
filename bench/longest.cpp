// The last 100 scenarios (the longest) of Berlin_0_512, a set on which other any-angle planners are easily run: Theta*,
// and the shortest paths of a square and of a point.
//
//     bench_longest [--repeats N] [--csv FILE] [--against FILE.csv]
//
// --csv writes the point's paths: columns start_x, start_y, goal_x, goal_y, length, microseconds. --against reads such
// a file of another optimal planner, taken on the same machine and core, and compares lengths and times.
#include <cmath>
#include <cstdio>
#include <fstream>

#include "maps.hpp"
#include "missions_of_paper.hpp"
#include "program.hpp"
#include "statistics.hpp"
#include "waybreaker/advanced/crossing.hpp"
#include "waybreaker/advanced/search.hpp"
#include "waybreaker/error.hpp"
#include "waybreaker/movingai.hpp"

namespace waybreaker::bench {
namespace {

struct Arguments {
    int repeats = 5;
    std::string csv;
    std::string against;
};

Arguments parse(std::span<char*> words) {
    Arguments arguments;
    for (std::size_t i = 1; i < words.size(); i += 2) {
        const std::string_view option = words[i];
        if (i + 1 < words.size() && option == "--repeats") {
            arguments.repeats = std::stoi(words[i + 1]);
        } else if (i + 1 < words.size() && option == "--csv") {
            arguments.csv = words[i + 1];
        } else if (i + 1 < words.size() && option == "--against") {
            arguments.against = words[i + 1];
        } else {
            throw InputError("usage: bench_longest [--repeats N] [--csv FILE] [--against FILE.csv]");
        }
    }
    return arguments;
}

std::vector<Scenario> longest_scenarios() {
    const std::filesystem::path file = shared_folder() / "data" / "cities" / "Berlin_0_512.map.scen";
    std::ifstream in(file, std::ios::binary);
    std::vector<Scenario> scenarios = read_movingai_scenarios(in, file.string());
    scenarios.erase(scenarios.begin(), scenarios.end() - std::ptrdiff_t(std::min<std::size_t>(100, scenarios.size())));
    return scenarios;
}

struct Measured {
    std::vector<double> lengths;
    std::vector<double> seconds;
};

// `find` gives the length of a path between two cells.
template <class Find>
Measured measure(const std::vector<Scenario>& scenarios, int repeats, Find find) {
    Measured measured;
    for (const Scenario& scenario : scenarios) {
        double length = find(scenario.start, scenario.goal);
        measured.seconds.push_back(least_seconds(repeats, [&] { length = find(scenario.start, scenario.goal); }));
        measured.lengths.push_back(length);
    }
    return measured;
}

void print(const char* name, const Measured& measured) {
    print_milliseconds(name, measured.seconds);
    std::printf("%-36s %8.3f cells\n", "  mean length", mean(measured.lengths));
}

void write_csv(const std::string& file, const std::vector<Scenario>& scenarios, const Measured& measured) {
    std::ofstream out(file);
    out << "start_x,start_y,goal_x,goal_y,length,microseconds\n";
    out.precision(12);
    for (std::size_t i = 0; i < scenarios.size(); ++i) {
        const Scenario& scenario = scenarios[i];
        out << scenario.start.x << ',' << scenario.start.y << ',' << scenario.goal.x << ',' << scenario.goal.y << ','
            << measured.lengths[i] << ',' << 1e6 * measured.seconds[i] << '\n';
    }
    if (!out) throw InputError(file, 0, "cannot be written");
}

void compare(const std::string& file, const std::vector<Scenario>& scenarios, const Measured& ours) {
    std::map<std::pair<Cell, Cell>, const CsvRow*> row_of;
    const std::vector<CsvRow> rows = read_csv(file);
    for (const CsvRow& row : rows) {
        const auto number = [&row](const char* name) { return std::stoi(row.at(name)); };
        row_of[{{number("start_x"), number("start_y")}, {number("goal_x"), number("goal_y")}}] = &row;
    }
    Measured theirs;
    std::size_t same = 0;
    for (std::size_t i = 0; i < scenarios.size(); ++i) {
        const CsvRow& row = *row_of.at({scenarios[i].start, scenarios[i].goal});
        theirs.lengths.push_back(std::stod(row.at("length")));
        theirs.seconds.push_back(1e-6 * std::stod(row.at("microseconds")));
        same += std::abs(theirs.lengths[i] - ours.lengths[i]) <= 1e-3 ? 1U : 0U;
    }
    print("theirs", theirs);
    std::printf("%zu of %zu lengths are the same to 0.001\n", same, scenarios.size());
    std::printf("point / theirs: %.3f (means), %.3f (geometric)\n", mean(ours.seconds) / mean(theirs.seconds),
                mean_ratio(ours.seconds, theirs.seconds));
}

void run(const Arguments& arguments) {
    const std::vector<Scenario> scenarios = longest_scenarios();
    const Map map(read_city("Berlin_0_512"));
    Searcher searcher;
    CrossingSearcher crossing;
    const auto shortest = [&](Body body) {
        return measure(scenarios, arguments.repeats, [&](Cell start, Cell goal) {
            return crossing.find(map, start, goal, {.body = body}).best.length;
        });
    };
    std::printf("%zu scenarios, least of %d repeats\n", scenarios.size(), arguments.repeats);
    print_header();
    print("Theta*", measure(scenarios, arguments.repeats,
                            [&](Cell start, Cell goal) { return searcher.find(OpenedMap(map), start, goal).length; }));
    print("shortest, square", shortest(Body{}));
    const Measured point = shortest(point_body);
    print("shortest, point", point);
    if (!arguments.csv.empty()) write_csv(arguments.csv, scenarios, point);
    if (!arguments.against.empty()) compare(arguments.against, scenarios, point);
}

}  // namespace
}  // namespace waybreaker::bench

int main(int argc, char** argv) {
    return waybreaker::bench::program("bench_longest", [&] {
        waybreaker::bench::run(waybreaker::bench::parse({argv, std::size_t(argc)}));
    });
}
