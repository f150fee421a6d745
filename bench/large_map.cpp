// The largest map, a city repeated over 16384 x 16384 cells: time and peak memory of reading, labelling and searching.
//
//     bench_large_map write FILE     makes the map as a MovingAI file of 256 MiB
//     bench_large_map read FILE      reads and labels it, then searches it; every peak is that of the process so far
#include <sys/resource.h>

#include <cstdio>
#include <fstream>
#include <optional>

#include "maps.hpp"
#include "program.hpp"
#include "statistics.hpp"
#include "waybreaker/advanced/search.hpp"
#include "waybreaker/error.hpp"
#include "waybreaker/movingai.hpp"

namespace waybreaker::bench {
namespace {

constexpr int side = 16384;
constexpr double cells = double(side) * side;

double peak_bytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return 1024.0 * double(usage.ru_maxrss);
}

void report(const char* step, double seconds) {
    std::printf("%-44s %12.6f s   peak %6.2f bytes a cell\n", step, seconds, peak_bytes() / cells);
}

void write(const std::string& file) {
    const Grid grid = mosaic(read_city("Berlin_0_512"), side);
    std::ofstream out(file, std::ios::binary);
    out << "type octile\nheight " << side << "\nwidth " << side << "\nmap\n";
    std::string row;
    for (int y = 0; y < side; ++y) {
        row.clear();
        for (int x = 0; x < side; ++x) row += grid.blocked({x, y}) ? '@' : '.';
        out << row << '\n';
    }
    if (!out) throw InputError(file, 0, "cannot be written");
}

Grid read_grid(const std::string& file) {
    std::ifstream in(file, std::ios::binary);
    return read_movingai_map(in, file);
}

// The free cell nearest to the right.
Cell free_from(const Map& map, Cell c) {
    while (map.grid().blocked(c)) ++c.x;
    return c;
}

void read(const std::string& file) {
    Grid grid(1, 1);
    report("read", seconds_of([&] { grid = read_grid(file); }));
    std::optional<Map> map;
    report("label", seconds_of([&] { map.emplace(std::move(grid)); }));

    const OpenedMap opened(*map);
    Searcher searcher;
    const auto search = [&](const char* step, Cell from, Cell to) {
        SearchResult result;
        report(step, seconds_of([&] { result = searcher.find(opened, free_from(*map, from), free_from(*map, to)); }));
        std::printf("    %llu expanded\n", static_cast<unsigned long long>(result.expanded));
    };
    search("short query, the first of its Searcher", {8000, 8000}, {8100, 8100});
    search("short query again", {8000, 8000}, {8100, 8100});
    search("short query elsewhere", {12000, 3000}, {12100, 3100});
    search("long query", {8, 8}, {side / 4, side / 4});
    search("short query after that", {8000, 8000}, {8100, 8100});
}

void run(std::span<char*> words) {
    const std::string command = words.size() == 3 ? words[1] : "";
    if (command == "write") return write(words[2]);
    if (command == "read") return read(words[2]);
    throw InputError("usage: bench_large_map write|read FILE");
}

}  // namespace
}  // namespace waybreaker::bench

int main(int argc, char** argv) {
    return waybreaker::bench::program("bench_large_map", [&] { waybreaker::bench::run({argv, std::size_t(argc)}); });
}
