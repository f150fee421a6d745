// What is drawn is drawn as often as it should be.
#include "rehearse/draws.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace waybreaker::rehearsal {
namespace {

constexpr int draws = 100'000;

double mean_delay(const Delay& delay, bool whole) {
    double sum = 0;
    for (int run = 0; run < draws / 10; ++run) {
        const Draws drawn(7, std::uint64_t(run));
        for (std::uint64_t move = 0; move < 10; ++move) {
            const double late = drawn.delay(delay, 3, move);
            EXPECT_GE(late, 0);
            EXPECT_TRUE(!whole || late == std::floor(late));
            sum += late;
        }
    }
    return sum / draws;
}

TEST(Draws, DelaysHaveTheirMean) {
    EXPECT_EQ(Draws(1, 1).delay({DelayKind::fixed, 2.5}, 0, 0), 2.5);
    EXPECT_EQ(Draws(1, 1).delay({DelayKind::exponential, 0}, 0, 0), 0);
    EXPECT_NEAR(mean_delay({DelayKind::exponential, 2}, false), 2, 0.03);
    EXPECT_NEAR(mean_delay({DelayKind::poisson, 2}, true), 2, 0.03);
    EXPECT_NEAR(mean_delay({DelayKind::poisson, 40}, true), 40, 0.1);
}

TEST(Draws, SharesAreEven) {
    int below = 0;
    for (int run = 0; run < draws; ++run) {
        if (Draws(1, std::uint64_t(run)).share(Chance::fails, 5) < 0.3) ++below;
    }
    EXPECT_NEAR(below / double(draws), 0.3, 0.005);
}

TEST(Draws, EachIsAnother) {
    const Draws one(1, 0);
    EXPECT_NE(one.share(Chance::fails, 1), one.share(Chance::fails, 2));
    EXPECT_NE(one.share(Chance::fails, 1, 0), one.share(Chance::fails, 1, 1));
    EXPECT_NE(one.share(Chance::fails, 1), one.share(Chance::is_lost, 1));
    EXPECT_NE(one.share(Chance::fails, 1), Draws(1, 1).share(Chance::fails, 1));
    EXPECT_NE(one.share(Chance::fails, 1), Draws(2, 0).share(Chance::fails, 1));
    EXPECT_EQ(one.share(Chance::fails, 1), Draws(1, 0).share(Chance::fails, 1));
}

}  // namespace
}  // namespace waybreaker::rehearsal
