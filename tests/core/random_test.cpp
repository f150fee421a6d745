#include "core/random.hpp"

#include <gtest/gtest.h>

#include <array>
#include <map>

namespace waybreaker {
namespace {

// The published reference values of SplitMix64.
TEST(Random, IsSplitMix64) {
    Random random(1234567);
    for (const std::uint64_t expected : {6457827717110365317U, 3203168211198807973U, 9817491932198370423U}) {
        EXPECT_EQ(random.next(), expected);
    }
}

TEST(Random, DrawsEachNumberBelowTheLimitAboutEquallyOften) {
    Random random(1);
    std::map<int, int> times;
    for (int i = 0; i < 70'000; ++i) ++times[random.below(7)];
    ASSERT_EQ(times.size(), 7U);
    EXPECT_EQ(times.begin()->first, 0);
    for (const auto& [number, count] : times) EXPECT_NEAR(count, 10'000, 500) << number;  // 5 standard deviations
}

TEST(Random, HitsAChanceThatOften) {
    Random random(2);
    int hits = 0;
    for (int i = 0; i < 100'000; ++i) hits += random.chance(0.3) ? 1 : 0;
    EXPECT_NEAR(hits, 30'000, 750);
    EXPECT_FALSE(random.chance(0));
    EXPECT_TRUE(random.chance(1));
}

}  // namespace
}  // namespace waybreaker
