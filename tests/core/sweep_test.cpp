// The swept strip against its definition, cell by cell.
#include "core/sweep.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace waybreaker {
namespace {

std::int64_t square(std::int64_t n) {
    return n * n;
}

// 2|c| < major + minor + 2 R L for R = 1/2 and R = 0, decided without a root.
bool disc_meets(std::int64_t major, std::int64_t minor, std::int64_t u, std::int64_t v) {
    const std::int64_t excess = 2 * std::abs(u * minor - v * major) - major - minor;
    return excess < 0 || square(excess) < square(major) + square(minor);
}
bool point_meets(std::int64_t major, std::int64_t minor, std::int64_t u, std::int64_t v) {
    return 2 * std::abs(u * minor - v * major) < major + minor;
}

template <class Meets>
void check_sweep(int major, int minor, std::int64_t reach, Meets meets) {
    Sweep sweep(major, minor, reach);
    for (int v = 0; v <= minor; ++v, sweep.next_line()) {
        for (int u = 0; u <= major; ++u) {
            ASSERT_EQ(meets(major, minor, u, v), sweep.first() <= u && u <= sweep.last())
                << "cell (" << u << ", " << v << ") of the segment to (" << major << ", " << minor << ")";
        }
    }
}

TEST(Sweep, MeetsExactlyTheCellsOfTheStrip) {
    for (int major = 1; major <= 60; ++major) {
        for (int minor = 1; minor <= major; ++minor) {
            check_sweep(major, minor, disc_reach(major, minor), disc_meets);
            check_sweep(major, minor, point_reach(major, minor), point_meets);
        }
    }
}

// On the longest segments only the ends of the intervals can be tested.
RC_GTEST_PROP(Sweep, IsExactOnTheLongestSegments, ()) {
    const int major = *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(20'000, 32'768));
    const int minor = *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(1, major + 1));
    Sweep sweep(major, minor, disc_reach(major, minor));
    for (int v = 0; v <= minor; ++v, sweep.next_line()) {
        RC_ASSERT(sweep.first() <= sweep.last());
        RC_ASSERT(disc_meets(major, minor, sweep.first(), v));
        RC_ASSERT(disc_meets(major, minor, sweep.last(), v));
        RC_ASSERT(sweep.first() == 0 || !disc_meets(major, minor, sweep.first() - 1, v));
        RC_ASSERT(sweep.last() == major || !disc_meets(major, minor, sweep.last() + 1, v));
    }
}

TEST(CeilSqrt, IsTheSmallestIntegerWhoseSquareIsEnough) {
    for (std::int64_t n = 0; n <= 100'000; ++n) {
        const std::int64_t root = ceil_sqrt(n);
        ASSERT_GE(root * root, n);
        ASSERT_TRUE(root == 0 || (root - 1) * (root - 1) < n) << n;
    }
    for (std::int64_t root = (std::int64_t{1} << 26) - 10'000; root < std::int64_t{1} << 26; ++root) {
        ASSERT_EQ(ceil_sqrt(root * root - 1), root);
        ASSERT_EQ(ceil_sqrt(root * root), root);
        ASSERT_EQ(ceil_sqrt(root * root + 1), root + 1);
    }
}

}  // namespace
}  // namespace waybreaker
