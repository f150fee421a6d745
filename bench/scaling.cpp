// What the exact search costs as things grow, one line a query, comma-separated, for plots.
//
//     bench_scaling mosaic SIDE...   one city, alone and as the middle of larger and larger mosaics of it
//     bench_scaling length           from near to far on a mosaic of 4096 x 4096
//     bench_scaling obstacles        from few large to many small obstacles on 512 x 512, a quarter of it blocked
//     bench_scaling removals         the missions of the paper, 0 to 8 crossings
#include <cstdio>
#include <random>

#include "maps.hpp"
#include "missions_of_paper.hpp"
#include "program.hpp"
#include "statistics.hpp"
#include "waybreaker/advanced/crossing.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::bench {
namespace {

constexpr int repeats = 5;
constexpr int queries = 20;  // of one kind
const std::string city = "Berlin_0_512";

class Bench {
  public:
    Bench() { std::printf("kind,at,obstacles,body,crossings,straight,length,expanded,generated,milliseconds\n"); }

    // `at`: the place of the line on the plot.
    void measure(const char* kind, double at, const Map& map, Cell start, Cell goal, Body body, int crossings) {
        const CrossingOptions options{.body = body, .crossings = crossings};
        const CrossingResult result = searcher_.find(map, start, goal, options);
        const double seconds = least_seconds(repeats, [&] { searcher_.find(map, start, goal, options); });
        std::printf("%s,%g,%zu,%s,%d,%.3f,%.6f,%llu,%llu,%.4f\n", kind, at, map.obstacles().size(),
                    body == Body{} ? "square" : "point", crossings, distance(start, goal), result.lower_bound,
                    static_cast<unsigned long long>(result.expanded), static_cast<unsigned long long>(result.generated),
                    1e3 * seconds);
    }

    // A pair of free cells about that far apart.
    std::pair<Cell, Cell> far_apart(const Map& map, double far) {
        std::uniform_int_distribution<int> x(0, map.width() - 1);
        std::uniform_int_distribution<int> y(0, map.height() - 1);
        std::uniform_real_distribution<double> angle(0, 6.283185307179586);
        while (true) {
            const Cell start{x(random_), y(random_)};
            const double towards = angle(random_);
            const Cell goal{start.x + int(far * std::cos(towards)), start.y + int(far * std::sin(towards))};
            const Grid& grid = map.grid();
            if (grid.contains(goal) && !grid.blocked(start) && !grid.blocked(goal)) return {start, goal};
        }
    }

    // As many equal squares at random; they may overlap.
    Map scattered(int count, int side) {
        Grid grid(512, 512);
        std::uniform_int_distribution<int> place(0, 512 - side);
        for (int i = 0; i < count; ++i) {
            const Cell min{place(random_), place(random_)};
            for (Cell c = min; c.y < min.y + side; ++c.y) {
                for (c.x = min.x; c.x < min.x + side; ++c.x) grid.set_blocked(c, true);
            }
        }
        return Map(std::move(grid));
    }

  private:
    CrossingSearcher searcher_;
    std::mt19937 random_{1};
};

void mosaics(Bench& bench, std::span<char*> sides) {
    for (const char* word : sides) {
        const int side = std::stoi(word);
        const Map map(mosaic(read_city(city), side));
        const int corner = side / 512 / 2 * 512;  // of the middle tile
        for (const CityMission& mission : missions_of_paper()) {
            if (mission.city != city) continue;
            const Cell start{mission.start.x + corner, mission.start.y + corner};
            const Cell goal{mission.goal.x + corner, mission.goal.y + corner};
            for (const int crossings : {0, 1, 3, 5}) {
                bench.measure("mosaic", side, map, start, goal, Body{}, crossings);
                bench.measure("mosaic", side, map, start, goal, point_body, crossings);
            }
        }
    }
}

void lengths(Bench& bench) {
    const Map map(mosaic(read_city(city), 4096));
    for (double far = 25; far <= 3200; far *= 2) {
        for (int i = 0; i < queries; ++i) {
            const auto [start, goal] = bench.far_apart(map, far);
            for (const int crossings : {0, 1, 3}) {
                bench.measure("length", far, map, start, goal, Body{}, crossings);
            }
        }
    }
}

void obstacles(Bench& bench) {
    for (int side = 64; side >= 1; side /= 2) {
        const int count = 512 * 512 / 4 / (side * side);
        const Map map = bench.scattered(count, side);
        for (int i = 0; i < queries; ++i) {
            const auto [start, goal] = bench.far_apart(map, 400);
            for (const int crossings : {0, 1, 3}) {
                bench.measure("obstacles", count, map, start, goal, Body{}, crossings);
            }
        }
    }
}

void removals(Bench& bench) {
    std::map<std::string, Map> maps;
    for (const CityMission& mission : missions_of_paper()) {
        const Map& map = maps.try_emplace(mission.city, read_city(mission.city)).first->second;
        for (int crossings = 0; crossings <= 8; ++crossings) {
            bench.measure("removals", crossings, map, mission.start, mission.goal, Body{}, crossings);
            bench.measure("removals", crossings, map, mission.start, mission.goal, point_body, crossings);
        }
    }
}

void run(std::span<char*> words) {
    const std::string kind = words.size() > 1 ? words[1] : "";
    if (kind != "mosaic" && kind != "length" && kind != "obstacles" && kind != "removals") {
        throw InputError("usage: bench_scaling mosaic SIDE... | length | obstacles | removals");
    }
    Bench bench;
    if (kind == "mosaic") mosaics(bench, words.subspan(2));
    if (kind == "length") lengths(bench);
    if (kind == "obstacles") obstacles(bench);
    if (kind == "removals") removals(bench);
}

}  // namespace
}  // namespace waybreaker::bench

int main(int argc, char** argv) {
    return waybreaker::bench::program("bench_scaling", [&] { waybreaker::bench::run({argv, std::size_t(argc)}); });
}
