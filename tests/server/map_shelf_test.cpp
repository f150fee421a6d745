// The shelf and its memory: all maps together take no more than they may.
#include "server/map_shelf.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "geo/label_tiff.hpp"
#include "server/problem.hpp"
#include "temporary_folder.hpp"

namespace waybreaker::server {
namespace {

class MapShelfTest : public TemporaryFolder {};

// A map of many small obstacles, about 80 KB in memory; `mark` makes it another one.
std::string studded(int mark = 0) {
    std::string text = "type octile\nheight 64\nwidth 64\nmap\n";
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 64; ++x) text += (y % 2 == 0 && x % 2 == 0) || (y == 1 && x == mark) ? '@' : '.';
        text += '\n';
    }
    return text;
}

ServiceLimits with_memory(std::size_t bytes) {
    ServiceLimits limits;
    limits.memory = bytes;
    return limits;
}

// What a call throws: status and kind.
template <class Call>
std::pair<int, std::string> problem_of(Call call) {
    try {
        call();
    } catch (const Problem& problem) {
        return {problem.status(), std::string(problem.kind())};
    }
    return {};
}

TEST_F(MapShelfTest, ForANewMapThoseGoThatWereNotUsedForLongest) {
    constexpr std::size_t most = 200'000;
    MapShelf shelf("", with_memory(most));
    const std::string first = shelf.add(studded(1), Connectivity::four).id;
    const std::string second = shelf.add(studded(3), Connectivity::four).id;
    EXPECT_GT(shelf.memory(), 120'000U);
    (void)shelf.take(first);
    shelf.add(studded(61), Connectivity::four);
    EXPECT_NE(shelf.take(first), nullptr);
    EXPECT_EQ(problem_of([&] { shelf.take(second); }), std::pair(404, std::string("map-not-found")));
    for (int mark = 5; mark < 60; mark += 2) {
        shelf.add(studded(mark), Connectivity::four);
        EXPECT_LE(shelf.memory(), most);
    }
}

TEST_F(MapShelfTest, WhatIsTooLargeAloneIsRefusedAndCostsTheOthersNothing) {
    MapShelf shelf("", with_memory(200'000));
    const std::string small = shelf.add("type octile\nheight 1\nwidth 2\nmap\n.@\n", Connectivity::four).id;
    const std::size_t before = shelf.memory();
    // A file of a few bytes with another obstacle in every cell.
    std::vector<std::uint32_t> labels(256 * 256);
    std::iota(labels.begin(), labels.end(), 1U);
    const std::string tiff = geo::label_tiff_bytes({.map = Map::from_labels(256, 256, std::move(labels))});
    std::string wide = "type octile\nheight 256\nwidth 256\nmap\n";
    for (int y = 0; y < 256; ++y) wide += std::string(256, '.') + '\n';
    for (const std::string& bytes : {tiff, wide}) {
        EXPECT_EQ(problem_of([&] { shelf.add(bytes, Connectivity::four); }),
                  std::pair(413, std::string("map-too-large")));
    }
    EXPECT_EQ(shelf.memory(), before);
    EXPECT_NE(shelf.take(small), nullptr);
}

TEST_F(MapShelfTest, MapsInUseTakeTheirMemoryStill) {
    MapShelf shelf("", with_memory(200'000));
    MapShelf::Upload first = shelf.add(studded(1), Connectivity::four);
    MapShelf::Upload second = shelf.add(studded(3), Connectivity::four);
    shelf.remove(first.id);
    EXPECT_GT(shelf.memory(), 120'000U);
    const auto third = [&] { shelf.add(studded(5), Connectivity::four); };
    EXPECT_EQ(problem_of(third), std::pair(503, std::string("no-memory")));
    first.map.reset();
    second.map.reset();
    EXPECT_EQ(problem_of(third), std::pair(0, std::string()));
}

TEST_F(MapShelfTest, MapsThatWereSentGoBeforeThoseOfTheFolder) {
    put("own.map", studded());
    MapShelf shelf(path("."), with_memory(200'000));
    (void)shelf.take("own.map");
    const std::string sent = shelf.add(studded(1), Connectivity::four).id;
    shelf.add(studded(3), Connectivity::four);
    EXPECT_NE(shelf.at_hand("own.map"), nullptr);
    EXPECT_EQ(problem_of([&] { shelf.take(sent); }).first, 404);
}

TEST_F(MapShelfTest, MapsOfTheFolderMustFitAsWell) {
    put("own.map", studded());
    MapShelf shelf(path("."), with_memory(50'000));
    EXPECT_EQ(problem_of([&] { shelf.take("own.map"); }), std::pair(422, std::string("map-beyond-memory")));
    EXPECT_EQ(shelf.memory(), 0U);
}

}  // namespace
}  // namespace waybreaker::server
