// Batches of default missions over one and over all threads: missions per second, and whether the plans are the same to
// the byte.
//
//     bench_batch [--rounds N] [--threads N]
//
// One batch a city: its missions of the paper's kind, many times over. Both numbers of threads take turns, so that what
// else the machine does disturbs both alike; processor time shows what threads cost each other.
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <limits>
#include <stdexcept>
#include <thread>

#include "io/plan_json.hpp"
#include "mapfile/map_reader.hpp"
#include "maps.hpp"
#include "missions_of_paper.hpp"
#include "program.hpp"
#include "statistics.hpp"
#include "waybreaker/error.hpp"
#include "waybreaker/planner.hpp"

namespace waybreaker::bench {
namespace {

constexpr int copies = 16;  // of each mission in a batch
constexpr double infinity = std::numeric_limits<double>::infinity();

struct Arguments {
    int rounds = 5;
    unsigned threads = std::max(1U, std::thread::hardware_concurrency());
};

Arguments parse(std::span<char*> words) {
    Arguments arguments;
    for (std::size_t i = 1; i < words.size(); i += 2) {
        const std::string_view option = words[i];
        if (i + 1 < words.size() && option == "--rounds") {
            arguments.rounds = std::stoi(words[i + 1]);
        } else if (i + 1 < words.size() && option == "--threads") {
            arguments.threads = unsigned(std::stoi(words[i + 1]));
        } else {
            throw InputError("usage: bench_batch [--rounds N] [--threads N]");
        }
    }
    return arguments;
}

struct Batch {
    io::MapFile map;
    std::vector<Mission> missions;

    // The plan files of all missions in a row.
    std::string bytes(std::span<const Expected<Plan>> plans) const {
        std::string text;
        for (std::size_t i = 0; i < plans.size(); ++i) {
            text += io::plan_json(*plans[i], {.map = map, .asked = {.mission = missions[i]}, .timing_fields = false});
        }
        return text;
    }
};

std::vector<Batch> batches() {
    std::map<std::string, std::vector<Mission>> missions;
    for (const CityMission& mission : missions_of_paper()) {
        missions[mission.city].push_back(ground_and_air(mission.start, mission.goal));
    }
    std::vector<Batch> batches;
    for (const auto& [city, its] : missions) {
        const std::filesystem::path file = shared_folder() / "data" / "cities" / (city + ".map");
        Batch& batch = batches.emplace_back(Batch{mapfile::read_map_file(file.string()), {}});
        for (int i = 0; i < copies; ++i) batch.missions.insert(batch.missions.end(), its.begin(), its.end());
    }
    return batches;
}

struct Times {
    double wall = 0;
    double processor = 0;  // of all threads together
};

Times time_of(const Batch& batch, unsigned threads) {
    const std::clock_t begun = std::clock();
    const double wall = seconds_of([&] { plan_all(batch.map.map, batch.missions, {}, {}, threads); });
    return {wall, double(std::clock() - begun) / CLOCKS_PER_SEC};
}

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

void run(const Arguments& arguments) {
    Times one;  // sums over the batches of the least of all rounds
    Times many;
    std::vector<double> ratios;
    std::size_t missions = 0;
    for (const Batch& batch : batches()) {
        if (batch.bytes(plan_all(batch.map.map, batch.missions, {}, {}, 1)) !=
            batch.bytes(plan_all(batch.map.map, batch.missions, {}, {}, arguments.threads))) {
            throw std::runtime_error("the plans for " + batch.map.source + " depend on the number of threads");
        }
        missions += batch.missions.size();
        Times least_one{infinity, infinity};
        Times least_many = least_one;
        for (int round = 0; round < arguments.rounds; ++round) {
            const Times alone = time_of(batch, 1);
            const Times together = time_of(batch, arguments.threads);
            ratios.push_back(alone.wall / together.wall);
            least_one = {std::min(least_one.wall, alone.wall), std::min(least_one.processor, alone.processor)};
            least_many = {std::min(least_many.wall, together.wall), std::min(least_many.processor, together.processor)};
        }
        one = {one.wall + least_one.wall, one.processor + least_one.processor};
        many = {many.wall + least_many.wall, many.processor + least_many.processor};
    }
    const auto print = [&](unsigned threads, const Times& times) {
        std::printf("%3u threads: %7.1f missions a second, %6.3f ms of processor time each\n", threads,
                    double(missions) / times.wall, 1e3 * times.processor / double(missions));
    };
    std::printf("%zu missions, least of %d rounds; the same bytes\n", missions, arguments.rounds);
    print(1, one);
    print(arguments.threads, many);
    std::printf("ratio: %.2f, median of the rounds %.2f; processor time %.2f times as much\n", one.wall / many.wall,
                median(ratios), many.processor / one.processor);
}

}  // namespace
}  // namespace waybreaker::bench

int main(int argc, char** argv) {
    return waybreaker::bench::program("bench_batch", [&] {
        waybreaker::bench::run(waybreaker::bench::parse({argv, std::size_t(argc)}));
    });
}
