// Cities whose obstacles are cut along a lattice, so that one breach opens a gap and no whole block: the paper's 144
// missions on a thousand small obstacles and more. For each number of removals how much the makespan falls, the
// certified gap, and the time of a plan.
//
//     bench_sections [--side CELLS] [--every K] [--gap SHARE] [--seconds S]    (K: only each K-th mission)
#include <algorithm>
#include <cstdio>
#include <limits>
#include <utility>

#include "maps.hpp"
#include "missions_of_paper.hpp"
#include "program.hpp"
#include "statistics.hpp"
#include "waybreaker/error.hpp"
#include "waybreaker/planner.hpp"

namespace waybreaker::bench {
namespace {

struct Arguments {
    int side = 8;
    std::size_t every = 1;
    double gap = 0;  // that is good enough
    double seconds = std::numeric_limits<double>::infinity();
};

Arguments parse(std::span<char*> words) {
    Arguments arguments;
    for (std::size_t i = 1; i < words.size(); i += 2) {
        const std::string_view option = words[i];
        const double number = i + 1 < words.size() ? std::stod(words[i + 1]) : -1;
        if (option == "--gap" && number >= 0) {
            arguments.gap = number;
        } else if (option == "--seconds" && number > 0) {
            arguments.seconds = number;
        } else if (option == "--side" && number >= 1) {
            arguments.side = int(number);
        } else if (option == "--every" && number >= 1) {
            arguments.every = std::size_t(number);
        } else {
            throw InputError("usage: bench_sections [--side CELLS] [--every K] [--gap SHARE] [--seconds S]");
        }
    }
    return arguments;
}

// One obstacle for each square of the lattice that has blocked cells.
Map sectioned(const Grid& grid, int side) {
    std::vector<std::uint32_t> labels(grid.cell_count());
    const int columns = (grid.width() + side - 1) / side;
    std::size_t cell = 0;
    for (Cell c{0, 0}; c.y < grid.height(); ++c.y) {
        for (c.x = 0; c.x < grid.width(); ++c.x, ++cell) {
            if (grid.blocked(c)) labels[cell] = std::uint32_t(c.y / side * columns + c.x / side + 1);
        }
    }
    return Map::from_labels(grid.width(), grid.height(), std::move(labels));
}

double middle(std::vector<double> values) {
    std::ranges::nth_element(values, values.begin() + std::ptrdiff_t(values.size() / 2));
    return values[values.size() / 2];
}

void run(const Arguments& arguments) {
    const std::vector<CityMission> missions = missions_of_paper();
    std::map<std::string, Map> cities;
    for (const CityMission& mission : missions) {
        if (!cities.contains(mission.city)) {
            cities.emplace(mission.city, sectioned(read_city(mission.city), arguments.side));
        }
    }
    Planner planner;
    std::printf("%4s %9s %9s %11s %11s %10s %10s %10s %9s\n", "n", "missions", "makespan", "gap, mean", "worst",
                "ms, mean", "median", "worst", "cut short");
    for (const int removals : {0, 1, 3, 5, 10, 16}) {
        std::vector<double> gaps;
        std::vector<double> seconds;
        std::vector<double> makespans;
        int cut = 0;
        for (std::size_t i = 0; i < missions.size(); i += arguments.every) {
            Mission mission = ground_and_air(missions[i].start, missions[i].goal);
            mission.rules.removals = removals;
            Plan plan;
            const Limits limits{.seconds = arguments.seconds, .gap = arguments.gap};
            seconds.push_back(
                seconds_of([&] { plan = planner.plan(cities.at(missions[i].city), mission, {}, limits); }));
            if (!plan.after.makespan) {
                ++cut;
                continue;
            }
            gaps.push_back(100 * plan.gap.value());
            makespans.push_back(plan.after.makespan.value());
            cut += plan.limit_reached ? 1 : 0;
        }
        std::printf("%4d %9zu %9.3f %9.3f %% %9.3f %% %10.2f %10.2f %10.1f %9d\n", removals, gaps.size(),
                    mean(makespans), mean(gaps), std::ranges::max(gaps), 1e3 * mean(seconds), 1e3 * middle(seconds),
                    1e3 * std::ranges::max(seconds), cut);
        std::fflush(stdout);
    }
}

}  // namespace
}  // namespace waybreaker::bench

int main(int argc, char** argv) {
    return waybreaker::bench::program("bench_sections", [&] {
        waybreaker::bench::run(waybreaker::bench::parse({argv, std::size_t(argc)}));
    });
}
