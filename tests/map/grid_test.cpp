#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "map/bit_run.hpp"
#include "random_map.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker {
namespace {

RC_GTEST_PROP(Grid, RemembersItsCellsInsideAFrame, ()) {
    const PlainMap plain = *random_map(140, 8);
    const Grid grid = plain.grid();
    for (int y = -1; y <= plain.height; ++y) {
        for (int x = -1; x <= plain.width; ++x) RC_ASSERT(grid.blocked({x, y}) == plain.blocked({x, y}));
    }
}

RC_GTEST_PROP(Grid, IsTransposed, ()) {
    const PlainMap plain = *random_map(*rc::gen::element(9, 70, 140), *rc::gen::element(9, 70, 140));
    const Grid grid = plain.grid();
    const Grid transposed = grid.transposed();
    RC_ASSERT(transposed.width() == plain.height);
    RC_ASSERT(transposed.height() == plain.width);
    for (int y = -1; y <= plain.height; ++y) {
        for (int x = -1; x <= plain.width; ++x) RC_ASSERT(transposed.blocked({y, x}) == plain.blocked({x, y}));
    }
    RC_ASSERT(transposed.transposed() == grid);
}

RC_GTEST_PROP(Grid, FreesAndBlocksSingleCells, ()) {
    PlainMap plain = *random_map(80, 4);
    Grid grid = plain.grid();
    for (int i = 0; i < 20; ++i) {
        const Cell c = any_cell(plain);
        const bool block = *rc::gen::arbitrary<bool>();
        plain.obstacles[plain.index(c)] = block ? 1 : 0;
        grid.set_blocked(c, block);
    }
    RC_ASSERT(grid == plain.grid());
}

TEST(Grid, KeepsToItsLimits) {
    EXPECT_THROW(Grid(0, 5), InputError);
    EXPECT_THROW(Grid(5, 0), InputError);
    EXPECT_THROW(Grid(-1, 5), InputError);
    EXPECT_THROW(Grid(max_side + 1, 1), InputError);
    EXPECT_THROW(Grid(1, max_side + 1), InputError);
    EXPECT_THROW(Grid(max_side, max_side), InputError);  // each side is fine, but not both
    EXPECT_THROW(Grid(2147483647, 2147483647), InputError);
    EXPECT_EQ(Grid(max_side, 1).width(), max_side);
    EXPECT_EQ(Grid(1, max_side).height(), max_side);
    EXPECT_EQ(Grid(1, max_side).transposed().width(), max_side);
}

RC_GTEST_PROP(BitRun, FindsAnySetBit, ()) {
    std::vector<std::uint64_t> line(4, 0);
    const int bits = *number(0, 3);
    for (int i = 0; i < bits; ++i) {
        const auto bit = unsigned(*number(0, 255));
        line[bit / 64] |= std::uint64_t{1} << (bit % 64);
    }
    const auto first = unsigned(*number(0, 255));
    const auto last = unsigned(*number(int(first), 255));
    bool expected = false;
    for (unsigned bit = first; bit <= last; ++bit) expected = expected || ((line[bit / 64] >> (bit % 64)) & 1U) != 0;
    RC_ASSERT(any_bit(line.data(), first, last) == expected);
}

TEST(Grid, RefusesCellsOffTheMap) {
    Grid grid(5, 3);
    const Grid untouched = grid;
    for (const Cell c : {Cell{-1, 0}, Cell{5, 0}, Cell{0, -1}, Cell{0, 3}, Cell{1 << 30, 1}, Cell{-(1 << 30), 1}}) {
        EXPECT_THROW(grid.set_blocked(c, true), InputError) << c.x << "," << c.y;
        EXPECT_THROW(grid.set_blocked(c, false), InputError) << c.x << "," << c.y;
    }
    EXPECT_EQ(grid, untouched);
}

}  // namespace
}  // namespace waybreaker
