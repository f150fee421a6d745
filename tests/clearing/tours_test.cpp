// The tours that are tried.
#include "clearing/tours.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

namespace waybreaker::clearing {
namespace {

constexpr ObstacleId a{1};
constexpr ObstacleId b{2};
constexpr ObstacleId c{3};

Stop onward(ObstacleId id) {
    return {id, Place::onward};
}
Stop soonest(ObstacleId id) {
    return {id, Place::soonest};
}

TEST(Tours, OfNobodyGrowByOne) {
    const std::array<ObstacleId, 2> pool{a, b};
    const std::array<int, 2> capacities{1, 0};
    const std::vector<Tours> found{{{onward(a)}, {}}, {{soonest(a)}, {}}, {{onward(b)}, {}}, {{soonest(b)}, {}}};
    EXPECT_EQ(neighbours({{}, {}}, pool, capacities, 3), found);
}

TEST(Tours, ChangeOneThing) {
    const std::array<ObstacleId, 3> pool{a, b, c};
    const std::array<int, 2> capacities{2, 2};
    const std::vector<Tours> found = neighbours({{onward(a), onward(b)}, {}}, pool, capacities, 2);
    const auto has = [&](const Tours& tours) { return std::ranges::count(found, tours) == 1; };
    EXPECT_TRUE(has({{onward(b)}, {}}) && has({{onward(a)}, {}}));                       // one less
    EXPECT_TRUE(has({{onward(b), soonest(a)}, {}}) && has({{onward(b)}, {onward(a)}}));  // elsewhere
    EXPECT_TRUE(has({{soonest(a), onward(b)}, {}}));                                     // from another place
    EXPECT_TRUE(has({{onward(a), soonest(c)}, {}}) && has({{onward(b)}, {onward(c)}}));  // another one
    EXPECT_FALSE(has({{onward(a), onward(b)}, {}}));
    for (const Tours& tours : found) EXPECT_LE(obstacles_of(tours).size(), 2U);
}

}  // namespace
}  // namespace waybreaker::clearing
