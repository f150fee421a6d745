// What a map is said to take is what it takes of the heap.
#include "io/map_memory.hpp"

#include <gtest/gtest.h>
#include <malloc.h>
#include <rapidcheck/gtest.h>

#include "map/map_size.hpp"
#include "random_map.hpp"

namespace waybreaker::io {
namespace {

std::size_t heap() {
    const auto info = mallinfo2();
    return info.uordblks + info.hblkhd;
}

// A blocked cell at every other place of every other row.
Grid studded(int side) {
    Grid grid(side, side);
    for (int y = 0; y < side; y += 2) {
        for (int x = 0; x < side; x += 2) grid.set_blocked({x, y}, true);
    }
    return grid;
}

TEST(MapMemory, IsWhatTheHeapGives) {
    if (heap() == 0) GTEST_SKIP() << "the sanitizer's heap does not report its size";
    for (const bool many : {false, true}) {
        Grid grid = many ? studded(2000) : Grid(2000, 2000);
        const std::size_t before = heap();
        const auto file = std::make_unique<MapFile>(MapFile{.map = Map(Grid(grid))});
        const auto taken = double(heap() - before);
        EXPECT_NEAR(double(memory_of(*file)) / taken, 1, 0.05) << many;
    }
}

TEST(MapMemory, CountsNamesAndBackground) {
    MapFile file{.map = Map(studded(10))};
    const std::size_t bare = memory_of(file);
    file.annotations.names.assign(26, std::string(250, 'x'));
    EXPECT_GT(memory_of(file), bare + 26 * 250);
    const std::size_t named = memory_of(file);
    file.annotations.background.features.push_back({.parts = {std::vector<Point>(1000)}});
    EXPECT_GT(memory_of(file), named + 1000 * sizeof(Point));
}

RC_GTEST_PROP(MapMemory, ObstaclesAreCountedBeforeTheyAreMade, ()) {
    const PlainMap plain = *random_map(20, 16);
    const auto connectivity = *rc::gen::element(Connectivity::four, Connectivity::eight);
    const Map map(plain.grid(), connectivity);
    RC_ASSERT(count_obstacles(plain.grid(), connectivity) == map.obstacles().size());
    const auto factor = *rc::gen::element<std::uint32_t>(1, 3, 1'000'000);
    std::vector<std::uint32_t> labels(map.labels().begin(), map.labels().end());
    for (std::uint32_t& label : labels) label *= factor;
    RC_ASSERT(count_labels(labels) == map.obstacles().size());
}

}  // namespace
}  // namespace waybreaker::io
