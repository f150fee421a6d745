// The default mission, whole, for 0 to 8 removals: how long it takes to plan, and how far its plans lie above the floor
// (reference/floors.csv in the shared folder: below it is no plan). Then the same vehicles alone, breaking what is in
// their way.
//
//     bench_exact [--repeats N] [--against FILE.csv]
//
// FILE.csv: another program's times for n = 3, as of bench_missions.
#include <cstdio>
#include <random>

#include "maps.hpp"
#include "missions_of_paper.hpp"
#include "program.hpp"
#include "statistics.hpp"
#include "waybreaker/error.hpp"
#include "waybreaker/planner.hpp"

namespace waybreaker::bench {
namespace {

constexpr int most_removals = 8;
constexpr int last_floor = 5;

struct Arguments {
    int repeats = 5;
    std::string against;
};

Arguments parse(std::span<char*> words) {
    Arguments arguments;
    for (std::size_t i = 1; i < words.size(); i += 2) {
        const std::string_view option = words[i];
        if (i + 1 < words.size() && option == "--repeats") {
            arguments.repeats = std::stoi(words[i + 1]);
        } else if (i + 1 < words.size() && option == "--against") {
            arguments.against = words[i + 1];
        } else {
            throw InputError("usage: bench_exact [--repeats N] [--against FILE.csv]");
        }
    }
    return arguments;
}

using Rows = std::map<CityMission, CsvRow>;

Rows rows_of(const std::filesystem::path& file) {
    Rows rows;
    for (CsvRow& row : read_csv(file)) rows.emplace(mission_of(row), row);
    return rows;
}

// For one number of removals, one entry a mission.
struct Measured {
    std::vector<double> seconds;
    std::vector<double> above_bound;  // makespan / bound proven
    std::vector<double> above_floor;  // makespan / floor
    std::size_t without_plan = 0;
};

class Bench {
  public:
    explicit Bench(int repeats) : repeats_(repeats), missions_(missions_of_paper()) {
        for (const CityMission& mission : missions_) maps_.try_emplace(mission.city, read_city(mission.city));
    }

    const std::vector<CityMission>& missions() const { return missions_; }

    Measured measure(int removals) {
        Measured measured;
        for (const CityMission& mission : missions_) {
            const Map& map = maps_.at(mission.city);
            Mission both = ground_and_air(mission.start, mission.goal);
            both.rules.removals = removals;
            const Plan plan = planner_.plan(map, both);
            measured.seconds.push_back(least_seconds(repeats_, [&] { planner_.plan(map, both); }));
            if (plan.status != PlanStatus::solved) {
                ++measured.without_plan;
                continue;
            }
            const double makespan = plan.after.makespan.value();
            if (plan.bound) measured.above_bound.push_back(makespan / *plan.bound);
            if (removals > last_floor) continue;
            const CsvRow& floors = floors_.at(mission);
            measured.above_floor.push_back(makespan / std::stod(floors.at("floor_" + std::to_string(removals))));
        }
        return measured;
    }

    // Each obstacle costs 1 to 100 cells to break. One entry a mission.
    std::vector<double> seconds_breaking() {
        std::vector<double> seconds;
        for (const CityMission& mission : missions_) {
            const Map& map = maps_.at(mission.city);
            std::mt19937 random(1);
            std::vector<double> costs(map.obstacles().size() + 1);
            for (double& cost : costs) cost = 1 + double(random() % 100);
            const auto cost = [&](const Obstacle& obstacle) { return costs[obstacle.id.value]; };
            seconds.push_back(
                least_seconds(repeats_, [&] { (void)planner_.path_through(map, mission.start, mission.goal, cost); }));
        }
        return seconds;
    }

  private:
    int repeats_;
    std::vector<CityMission> missions_;
    std::map<std::string, Map> maps_;
    Rows floors_ = rows_of(shared_folder() / "reference" / "floors.csv");
    Planner planner_;
};

void print_excess(const char* what, const std::vector<double>& ratios) {
    if (ratios.empty()) return;
    std::printf("    %-32s %+7.4f %% mean, %+7.4f %% worst\n", what, 100 * (mean(ratios) - 1),
                100 * (*std::max_element(ratios.begin(), ratios.end()) - 1));
}

void print_ratios(const std::string& file, const std::vector<CityMission>& missions, const Measured& ours) {
    const Rows rows = rows_of(file);
    std::vector<double> theirs;
    for (const CityMission& mission : missions) {
        theirs.push_back(std::stod(rows.at(mission).at("time_both_seconds")));
    }
    print_milliseconds("theirs: both searches, n = 3", theirs);
    std::printf("theirs / ours, n = 3: %.1f (means), %.1f (geometric)\n", mean(theirs) / mean(ours.seconds),
                mean_ratio(theirs, ours.seconds));
}

void run(const Arguments& arguments) {
    Bench bench(arguments.repeats);
    std::printf("%zu missions, least of %d repeats\n", bench.missions().size(), arguments.repeats);
    print_header();
    Measured three;
    for (int removals = 0; removals <= most_removals; ++removals) {
        const Measured measured = bench.measure(removals);
        print_milliseconds("n = " + std::to_string(removals), measured.seconds);
        print_excess("makespan above its own bound", measured.above_bound);
        print_excess("makespan above the floor", measured.above_floor);
        if (measured.without_plan > 0) std::printf("    %zu without a plan\n", measured.without_plan);
        if (removals == 3) three = measured;
    }
    print_milliseconds("a vehicle that breaks by itself", bench.seconds_breaking());
    if (!arguments.against.empty()) print_ratios(arguments.against, bench.missions(), three);
}

}  // namespace
}  // namespace waybreaker::bench

int main(int argc, char** argv) {
    return waybreaker::bench::program("bench_exact", [&] {
        waybreaker::bench::run(waybreaker::bench::parse({argv, std::size_t(argc)}));
    });
}
