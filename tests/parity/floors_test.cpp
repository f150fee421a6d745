// Crossing paths of a point against reference/floors.csv: the length of the shortest path on city maps that crosses at
// most 0 to 5 obstacles, found by another program.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>
#include <sstream>

#include "shared_data.hpp"
#include "waybreaker/advanced/crossing.hpp"
#include "waybreaker/movingai.hpp"

namespace waybreaker {
namespace {

namespace fs = std::filesystem;

constexpr int most_crossings = 5;

struct Floors {
    std::string map;
    Cell start;
    Cell goal;
    std::array<double, most_crossings + 1> floors;
};

std::vector<Floors> read_floors(const fs::path& file) {
    std::ifstream in(file);
    std::string line;
    std::getline(in, line);
    EXPECT_EQ(line, "map,start_x,start_y,goal_x,goal_y,straight,floor_0,floor_1,floor_2,floor_3,floor_4,floor_5");
    std::vector<Floors> rows;
    while (std::getline(in, line)) {
        std::replace(line.begin(), line.end(), ',', ' ');
        std::istringstream fields(line);
        Floors& row = rows.emplace_back();
        double straight = 0;
        fields >> row.map >> row.start.x >> row.start.y >> row.goal.x >> row.goal.y >> straight;
        for (double& floor : row.floors) fields >> floor;
        EXPECT_TRUE(fields) << line;
    }
    return rows;
}

TEST(Floors, AreTheShortestPathsOfAPoint) {
    const auto shared = shared_folder();
    if (!shared || !fs::exists(*shared / "reference" / "floors.csv")) GTEST_SKIP() << no_shared_folder;
    const std::vector<Floors> rows = read_floors(*shared / "reference" / "floors.csv");
    EXPECT_EQ(rows.size(), 144U);
    std::map<std::string, Map> maps;
    CrossingSearcher searcher;
    for (const Floors& row : rows) {
        if (!maps.contains(row.map)) {
            const fs::path file = *shared / "data" / "cities" / (row.map + ".map");
            std::ifstream in(file, std::ios::binary);
            maps.emplace(row.map, read_movingai_map(in, file.string()));
        }
        const Map& map = maps.at(row.map);
        for (int n = 0; n <= most_crossings; ++n) {
            SCOPED_TRACE(testing::Message() << row.map << ' ' << row.start.x << ',' << row.start.y << " to "
                                            << row.goal.x << ',' << row.goal.y << ", n = " << n);
            const double floor = row.floors[std::size_t(n)];
            const CrossingResult point = searcher.find(map, row.start, row.goal, {.body = point_body, .crossings = n});
            const CrossingResult square = searcher.find(map, row.start, row.goal, {.body = Body{}, .crossings = n});
            EXPECT_NEAR(point.best.length, floor, 1e-4 + 1e-6 * floor);  // given to four digits after the point
            EXPECT_GE(square.best.length, point.best.length * (1 - 1e-12));
            EXPECT_LE(point.best.crossed.size(), std::size_t(n));
            EXPECT_LE(square.best.crossed.size(), std::size_t(n));
        }
    }
}

}  // namespace
}  // namespace waybreaker
