// The closed formulas of motion against small steps in time.
#include "safe_interval/motion.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "random_map.hpp"

namespace waybreaker::safe_interval {
namespace {

double tenths(int first, int last) {
    return *number(first, last) / 10.0;
}
Vector any_vector(int size) {
    return {tenths(-size, size), tenths(-size, size)};
}
Leg any_leg() {
    Leg leg{any_vector(40), any_vector(15), tenths(0, 40), 0};
    leg.to = leg.from + tenths(1, 60);
    if (*number(0, 3) == 0) leg.velocity = {};
    if (leg.velocity.x == 0 && leg.velocity.y == 0 && *number(0, 3) == 0) leg.to = for_ever;
    return leg;
}

double apart(Vector a, Vector b) {
    return std::hypot(a.x - b.x, a.y - b.y);
}

// The least distance of two legs at times they share, in small steps; infinity if they share none.
double least_apart(const Leg& a, const Leg& b) {
    const double from = std::max(a.from, b.from);
    const double to = std::min({a.to, b.to, 100.0});
    double least = for_ever;
    constexpr int steps = 2000;
    for (int k = 0; k <= steps && from < to; ++k) {
        const double time = from + k * (to - from) / steps;
        least = std::min(least, apart(a.at(time), b.at(time)));
    }
    return least;
}

constexpr double coarse = 0.02;  // what a step can hide

RC_GTEST_PROP(Motion, OverlapsWhereSmallStepsDo, ()) {
    const Leg a = any_leg();
    const Leg b = any_leg();
    const double reach = tenths(1, 30);
    const Interval found = overlap(a, b, reach);
    const double least = least_apart(a, b);
    if (least < reach - coarse) RC_ASSERT(!found.empty());
    if (least > reach + coarse) RC_ASSERT(found.empty());
    if (found.empty() || std::isinf(found.to)) return;
    const double middle = (found.from + found.to) / 2;
    RC_ASSERT(apart(a.at(middle), b.at(middle)) < reach + 1e-9);
    // It begins where they meet, or where one of them does.
    const bool begins = std::abs(apart(a.at(found.from), b.at(found.from)) - reach) < 1e-6;
    RC_ASSERT(begins || found.from == std::max(a.from, b.from));
}

RC_GTEST_PROP(Motion, UnsafeDeparturesAreThoseThatOverlap, ()) {
    const Leg other = any_leg();
    const Move move{any_vector(40), any_vector(15), tenths(1, 50)};
    RC_PRE(move.velocity.x != 0 || move.velocity.y != 0);
    const double reach = tenths(1, 30);
    const Interval unsafe = unsafe_departures(move, other, reach);
    for (int k = 0; k < 40; ++k) {
        const double departure = tenths(-80, 150) + 0.0371;
        const Leg driven{move.start, move.velocity, departure, departure + move.duration};
        const bool meets = !overlap(driven, other, reach).empty();
        const bool said = unsafe.from < departure && departure < unsafe.to;
        const bool at_an_end = std::abs(departure - unsafe.from) < 1e-6 || std::abs(departure - unsafe.to) < 1e-6;
        // Who starts exactly at reach overlaps or not, by rounding.
        const bool touches =
            overlap(driven, other, reach - 1e-9).empty() != overlap(driven, other, reach + 1e-9).empty();
        RC_ASSERT(said == meets || at_an_end || touches);
    }
}

TEST(Motion, TouchingIsNoOverlap) {
    const Leg right{{0, 0}, {1, 0}, 0, 10};
    const Leg beside{{0, 1}, {1, 0}, 0, 10};
    EXPECT_TRUE(overlap(right, beside, 1).empty());
    EXPECT_FALSE(overlap(right, beside, 1.001).empty());
    const Leg stands{{5, 1}, {}, 0, for_ever};
    EXPECT_TRUE(overlap(right, stands, 1).empty());
}

TEST(Motion, HeadOnMeetsHalfWay) {
    const Leg right{{0, 0}, {1, 0}, 0, 10};
    const Leg left{{10, 0}, {-1, 0}, 0, 10};
    const Interval found = overlap(right, left, 1);
    EXPECT_DOUBLE_EQ(found.from, 4.5);
    EXPECT_DOUBLE_EQ(found.to, 5.5);
}

}  // namespace
}  // namespace waybreaker::safe_interval
