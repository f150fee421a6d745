#include "experiment/terrain.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <vector>

#include "input_error.hpp"
#include "plain_map.hpp"

namespace waybreaker::experiment {
namespace {

constexpr std::array kinds{Terrain::maze, Terrain::rooms, Terrain::spiral, Terrain::blocks, Terrain::random};

std::size_t blocked(const Map& map) {
    const auto obstacles = map.obstacles();
    return std::accumulate(obstacles.begin(), obstacles.end(), std::size_t{0},
                           [](std::size_t sum, const Obstacle& obstacle) { return sum + obstacle.cells; });
}

// How many free cells one can walk to from the first one, side by side.
std::size_t reached(const Map& map) {
    const PlainMap cells = plain(map);
    std::vector<bool> seen(cells.obstacles.size(), false);
    std::vector<Cell> open{cells.free_cells().front()};
    seen[cells.index(open[0])] = true;
    for (std::size_t i = 0; i < open.size(); ++i) {
        for (const Cell step : {Cell{1, 0}, Cell{-1, 0}, Cell{0, 1}, Cell{0, -1}}) {
            const Cell to{open[i].x + step.x, open[i].y + step.y};
            if (cells.blocked(to) || seen[cells.index(to)]) continue;
            seen[cells.index(to)] = true;
            open.push_back(to);
        }
    }
    return open.size();
}

TEST(Terrain, LeavesNoPlaceWithoutAWay) {
    for (const Terrain kind : {Terrain::maze, Terrain::rooms, Terrain::spiral, Terrain::blocks}) {
        for (const int side : {100, 251, 501}) {
            const Map map = make_terrain(kind, {.side = side, .seed = std::uint64_t(side)});
            EXPECT_EQ(reached(map), std::size_t(side) * std::size_t(side) - blocked(map)) << int(kind) << " " << side;
        }
    }
}

TEST(Terrain, HasTheWallsOfATree) {
    // 20 x 20 rooms have 760 walls, of which a tree opens 399.
    const Map maze = make_terrain(Terrain::maze, {.seed = 3});
    EXPECT_EQ(maze.obstacles().size(), 760U - 399U);
    // Doors do not remove walls.
    EXPECT_EQ(make_terrain(Terrain::rooms, {.seed = 3}).obstacles().size(), 180U);
    EXPECT_EQ(make_terrain(Terrain::spiral, {.seed = 3}).obstacles().size(), 25U);
    EXPECT_LT(make_terrain(Terrain::maze, {.share = 0.5, .seed = 3}).obstacles().size(), 250U);
    EXPECT_NEAR(double(blocked(make_terrain(Terrain::random, {.share = 0.35}))) / (501 * 501), 0.35, 0.01);
}

TEST(Terrain, IsTheSameForTheSameSeedOnly) {
    for (const Terrain kind : kinds) {
        const auto labels = [&](std::uint64_t seed) {
            const Map map = make_terrain(kind, {.side = 200, .seed = seed});
            return std::vector(map.labels().begin(), map.labels().end());
        };
        EXPECT_EQ(labels(1), labels(1));
        EXPECT_NE(labels(1), labels(2));
    }
}

// Pins what is drawn: it must not change between versions or platforms.
TEST(Terrain, IsTheSameEverywhere) {
    std::vector<std::size_t> cells;
    for (const Terrain kind : kinds) cells.push_back(blocked(make_terrain(kind, {.seed = 1})));
    EXPECT_EQ(cells, (std::vector<std::size_t>{18098, 16832, 49600, 164641, 62461}));
}

TEST(Terrain, RefusesWhatCannotBeDrawn) {
    for (const Terrain kind : kinds) {
        EXPECT_GT(make_terrain(kind, {.side = least_terrain_side}).obstacles().size(), 0U);
        EXPECT_EQ(input_error([&] { make_terrain(kind, {.side = 31}); }),
                  "the side of a made-up map is from 32 to 16384 cells");
        EXPECT_EQ(input_error([&] { make_terrain(kind, {.share = 1.5}); }), "a share is from 0 to 1");
    }
}

}  // namespace
}  // namespace waybreaker::experiment
