// The tours that are tried.
#include "crew/tours.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

namespace waybreaker::crew {
namespace {

constexpr ObstacleId a{1};
constexpr ObstacleId b{2};
constexpr ObstacleId c{3};

TEST(Tours, OfNobodyGrowByOne) {
    const std::array<ObstacleId, 2> pool{a, b};
    const std::array<int, 2> capacities{1, 0};
    EXPECT_EQ(neighbours({{}, {}}, pool, capacities, 3), (std::vector<Tours>{{{a}, {}}, {{b}, {}}}));
}

TEST(Tours, ChangeOneThing) {
    const std::array<ObstacleId, 3> pool{a, b, c};
    const std::array<int, 2> capacities{2, 2};
    const std::vector<Tours> found = neighbours({{a, b}, {}}, pool, capacities, 2);
    const auto has = [&](const Tours& tours) { return std::ranges::count(found, tours) == 1; };
    EXPECT_TRUE(has({{b}, {}}) && has({{a}, {}}));                                  // one less
    EXPECT_TRUE(has({{b, a}, {}}) && has({{b}, {a}}) && has({{a}, {b}}));           // in another place
    EXPECT_TRUE(has({{a, c}, {}}) && has({{c, a}, {}}) && has({{c, b}, {}}) && has({{b}, {c}}));  // another one
    EXPECT_FALSE(has({{a, b}, {}}));
    for (const Tours& tours : found) EXPECT_LE(obstacles_of(tours).size(), 2U);
}

}  // namespace
}  // namespace waybreaker::crew
