// The paper's whole method as pictures: map in, plan out.
//
// In the plans `x` is a removed obstacle, `+` a turn of the ground agent, `o` a place where the air agent breaches.
#include <gtest/gtest.h>

#include "ascii_map.hpp"
#include "paper_plan.hpp"

namespace waybreaker {
namespace {

std::string joined(const std::vector<std::string>& rows) {
    std::string picture;
    for (const std::string& row : rows) picture += row + '\n';
    return picture;
}

std::string drawn(const Map& map, const Plan& plan) {
    std::vector<std::string> rows(std::size_t(map.height()), std::string(std::size_t(map.width()), '.'));
    const auto at = [&rows](Cell c) -> char& { return rows[std::size_t(c.y)][std::size_t(c.x)]; };
    for (Cell c; c.y < map.height(); ++c.y) {
        for (c.x = 0; c.x < map.width(); ++c.x) {
            if (map.obstacle_at(c)) at(c) = '#';
            for (const Breach& breach : plan.breaches) at(c) = breach.obstacle == map.obstacle_at(c) ? 'x' : at(c);
        }
    }
    for (const Point p : plan.after.ground().path) at({int(p.x), int(p.y)}) = '+';
    for (const Breach& breach : plan.breaches) at(breach.at) = 'o';
    at(plan.agents[1].start) = 'S';
    at(plan.agents[1].goal) = 'G';
    return joined(rows);
}

// The paper's method on a map with S and G.
std::string planned(std::string_view picture, int removals) {
    const Map map = map_from_ascii(picture);
    const Mission mission = ground_and_air(mark_in_ascii(picture, 'S'), mark_in_ascii(picture, 'G'));
    return drawn(map, paper_plan(map, mission, removals));
}

std::string expected(std::string_view picture) {
    return joined(ascii_rows(picture));
}

constexpr std::string_view wall = R"(
    .............
    ......aa.....
    ......aa.....
    S.....aa....G
    ......aa.....
    ......aa.....
    .............)";

TEST(MissionPicture, AWallToDriveAround) {
    EXPECT_EQ(planned(wall, 0), expected(R"(
        .....+..+....
        ......##.....
        ......##.....
        S.....##....G
        ......##.....
        ......##.....
        .............)"));
}

TEST(MissionPicture, AWallToRemove) {
    EXPECT_EQ(planned(wall, 1), expected(R"(
        .............
        ......xx.....
        ......xx.....
        S....oxx....G
        ......xx.....
        ......xx.....
        .............)"));
}

constexpr std::string_view walls = R"(
    ...........b....
    ....a......b....
    ....a..c...b....
    S...a......b...G
    ....a......b....
    ....a...........)";

TEST(MissionPicture, TwoWallsAndAStone) {
    EXPECT_EQ(planned(walls, 1), expected(R"(
        ...........#....
        ....x......#....
        ....x..#...#....
        S..ox......#...G
        ....x......#....
        ....x.....+.+...)"));
    EXPECT_EQ(planned(walls, 2), expected(R"(
        ...........x....
        ....x......x....
        ....x..#...x....
        S..ox.....ox...G
        ....x......x....
        ....x...........)"));
    // The stone is not in the way, but the search has looked at it.
    EXPECT_EQ(planned(walls, 3), expected(R"(
        ...........x....
        ....x......x....
        ....x..x...x....
        S..ox.o...ox...G
        ....x......x....
        ....x...........)"));
}

TEST(MissionPicture, APrison) {
    EXPECT_EQ(planned(R"(
        ..aaaaa..
        ..a...a..
        ..a.S.a.G
        ..a...a..
        ..aaaaa..)",
                      1),
              expected(R"(
        ..xxxxx..
        ..x...x..
        ..x.Sox.G
        ..x...x..
        ..xxxxx..)"));
}

}  // namespace
}  // namespace waybreaker
