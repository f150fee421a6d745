// Sets of obstacles, against all numbers whose bits name them.
#include "model/all_sets.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <numeric>
#include <set>

#include "random_map.hpp"

namespace waybreaker {
namespace {

using ObstacleSet = std::vector<ObstacleId>;

std::uint32_t sum(std::span<const ObstacleId> set) {
    return std::accumulate(set.begin(), set.end(), 0U, [](std::uint32_t s, ObstacleId id) { return s + id.value; });
}

RC_GTEST_PROP(AllSets, AreAllThatAreAllowed, ()) {
    const int count = *number(0, 7);
    const int largest = *number(0, 8);
    const std::uint32_t budget = std::uint32_t(*number(0, 40));
    ObstacleSet obstacles;
    for (int i = 0; i < count; ++i) obstacles.push_back({std::uint32_t(3 * i + 1)});
    std::set<ObstacleSet> expected;
    for (std::uint32_t bits = 0; bits < 1U << count; ++bits) {
        ObstacleSet set;
        for (int i = 0; i < count; ++i) {
            if ((bits >> i & 1U) != 0) set.push_back(obstacles[std::size_t(i)]);
        }
        if (std::popcount(bits) <= largest && sum(set) <= budget) expected.insert(set);
    }
    const auto allowed = [&](std::span<const ObstacleId> set) { return sum(set) <= budget; };
    const std::vector<ObstacleSet> found = all_sets(obstacles, largest, allowed, 128);
    RC_ASSERT(std::set<ObstacleSet>(found.begin(), found.end()) == expected);
    RC_ASSERT(found.size() == expected.size());
    RC_ASSERT(std::ranges::is_sorted(found, {}, &ObstacleSet::size));
}

TEST(AllSets, AreNoneWhereThereAreTooMany) {
    const ObstacleSet obstacles{{1}, {2}, {3}, {4}};
    const auto any = [](std::span<const ObstacleId>) { return true; };
    EXPECT_EQ(all_sets(obstacles, 2, any, 11).size(), 11U);
    EXPECT_TRUE(all_sets(obstacles, 2, any, 10).empty());
}

}  // namespace
}  // namespace waybreaker
