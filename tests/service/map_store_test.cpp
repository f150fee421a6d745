// The map store keeps within its memory limit.
#include "service/map_store.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <numeric>

#include "geotiff/label_tiff.hpp"
#include "http/problem.hpp"
#include "temporary_folder.hpp"

namespace waybreaker::service {
namespace {

// A store, and its memory.
struct Store {
    explicit Store(std::size_t bytes, const std::string& folder = "")
        : budget(bytes), maps(folder, ServiceLimits(), budget) {}
    MemoryBudget budget;
    MapStore maps;
};

class MapStoreTest : public TemporaryFolder {};

// A map of many small obstacles, about 80 KB in memory; `mark` makes it another one.
std::string studded(int mark = 0) {
    std::string text = "type octile\nheight 64\nwidth 64\nmap\n";
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 64; ++x) text += (y % 2 == 0 && x % 2 == 0) || (y == 1 && x == mark) ? '@' : '.';
        text += '\n';
    }
    return text;
}

// What a call throws: status and kind.
template <class Call>
std::pair<int, std::string> problem_of(Call call) {
    try {
        call();
    } catch (const http::Problem& problem) {
        return {problem.status(), std::string(problem.kind())};
    }
    return {};
}

TEST_F(MapStoreTest, EvictsTheLeastRecentlyUsed) {
    constexpr std::size_t most = 200'000;
    Store store(most);
    const std::string first = store.maps.add(studded(1), Connectivity::four).id;
    const std::string second = store.maps.add(studded(3), Connectivity::four).id;
    EXPECT_GT(store.budget.used(), 120'000U);
    (void)store.maps.load(first);
    store.maps.add(studded(61), Connectivity::four);
    EXPECT_NE(store.maps.load(first), nullptr);
    EXPECT_EQ(problem_of([&] { store.maps.load(second); }), std::pair(404, std::string("map-not-found")));
    for (int mark = 5; mark < 60; mark += 2) {
        store.maps.add(studded(mark), Connectivity::four);
        EXPECT_LE(store.budget.used(), most);
    }
}

TEST_F(MapStoreTest, RefusesAMapThatCannotFitAndEvictsNoOther) {
    Store store(200'000);
    const std::string small = store.maps.add("type octile\nheight 1\nwidth 2\nmap\n.@\n", Connectivity::four).id;
    const std::size_t before = store.budget.used();
    // A file of a few bytes with another obstacle in every cell.
    std::vector<std::uint32_t> labels(256 * 256);
    std::iota(labels.begin(), labels.end(), 1U);
    const std::string tiff = geotiff::label_tiff_bytes({.map = Map::from_labels(256, 256, std::move(labels))});
    std::string wide = "type octile\nheight 256\nwidth 256\nmap\n";
    for (int y = 0; y < 256; ++y) wide += std::string(256, '.') + '\n';
    for (const std::string& bytes : {tiff, wide}) {
        EXPECT_EQ(problem_of([&] { store.maps.add(bytes, Connectivity::four); }),
                  std::pair(413, std::string("map-too-large")));
    }
    EXPECT_EQ(store.budget.used(), before);
    EXPECT_NE(store.maps.load(small), nullptr);
}

TEST_F(MapStoreTest, RemovedMapsInUseStillCount) {
    Store store(200'000);
    MapStore::Upload first = store.maps.add(studded(1), Connectivity::four);
    MapStore::Upload second = store.maps.add(studded(3), Connectivity::four);
    store.maps.remove(first.id);
    EXPECT_GT(store.budget.used(), 120'000U);
    const auto third = [&] { store.maps.add(studded(5), Connectivity::four); };
    EXPECT_EQ(problem_of(third), std::pair(503, std::string("no-memory")));
    first.map.reset();
    second.map.reset();
    EXPECT_EQ(problem_of(third), std::pair(0, std::string()));
}

// That would give back nothing.
TEST_F(MapStoreTest, DoesNotEvictMapsInUse) {
    Store store(200'000);
    const MapStore::Upload used = store.maps.add(studded(1), Connectivity::four);
    for (int mark = 3; mark < 20; mark += 2) store.maps.add(studded(mark), Connectivity::four);
    EXPECT_EQ(store.maps.load(used.id), used.map);
}

TEST_F(MapStoreTest, MakesRoomForPlans) {
    Store store(200'000);
    const std::string first = store.maps.add(studded(1), Connectivity::four).id;
    const MapStore::Upload second = store.maps.add(studded(3), Connectivity::four);
    MemoryBudget::Share plan(store.budget, MemoryBudget::Use::planner);
    EXPECT_TRUE(plan.grow(100'000));
    EXPECT_EQ(problem_of([&] { store.maps.load(first); }).first, 404);
    EXPECT_EQ(store.maps.load(second.id), second.map);
    EXPECT_FALSE(plan.grow(50'000));
}

TEST_F(MapStoreTest, EvictsUploadsBeforeMapsOfTheFolder) {
    put("own.map", studded());
    Store store(200'000, path("."));
    (void)store.maps.load("own.map");
    const std::string sent = store.maps.add(studded(1), Connectivity::four).id;
    store.maps.add(studded(3), Connectivity::four);
    EXPECT_NE(store.maps.if_loaded("own.map"), nullptr);
    EXPECT_EQ(problem_of([&] { store.maps.load(sent); }).first, 404);
}

TEST_F(MapStoreTest, RefusesMapsOfTheFolderThatCannotFit) {
    put("own.map", studded());
    Store store(50'000, path("."));
    EXPECT_EQ(problem_of([&] { store.maps.load("own.map"); }), std::pair(422, std::string("map-beyond-memory")));
    EXPECT_EQ(store.budget.used(), 0U);
}

TEST_F(MapStoreTest, RefusesFilesByTheirSizeBeforeItReadsThem) {
    put("huge.map", "type octile\n");
    std::filesystem::resize_file(path("huge.map"), std::uintmax_t{1} << 40);
    put("none.map", "");
    std::filesystem::resize_file(path("none.map"), std::uintmax_t{1} << 16);
    Store store(200'000, path("."));
    EXPECT_EQ(problem_of([&] { store.maps.load("huge.map"); }), std::pair(422, std::string("map-beyond-memory")));
    EXPECT_EQ(problem_of([&] { store.maps.load("none.map"); }), std::pair(422, std::string("map-unreadable")));
    EXPECT_EQ(store.budget.used(), 0U);
}

}  // namespace
}  // namespace waybreaker::service
