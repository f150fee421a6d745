// The two claims by which Theta* infers sight (search/parents.hpp), for every segment up to some length.
//
// A segment runs from (0, 0) to (major, minor), major >= minor >= 0; its strip is the cells of core/sweep.hpp in its
// box, taken here from the definition.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

namespace waybreaker {
namespace {

constexpr int longest = 200;
constexpr int furthest_line = 8;

bool in_strip(int major, int minor, int u, int v) {
    if (u < 0 || u > major || v < 0 || v > minor) return false;
    const int excess = 2 * std::abs(u * minor - v * major) - major - minor;
    return excess < 0 || excess * excess < major * major + minor * minor;
}

// Calls visit(u, v) for the strip's cells on lines first to last; v is searched near the segment.
template <class Visit>
void for_each_cell(int major, int minor, int first, int last, Visit visit) {
    for (int u = first; u <= last; ++u) {
        const int middle = u * minor / major;
        for (int v = std::max(middle - 3, 0); v <= std::min(middle + 4, minor); ++v) {
            if (in_strip(major, minor, u, v)) visit(u, v);
        }
    }
}

TEST(InferredSight, StripLiesWithinTwoCellsOfTheSegment) {
    for (int major = 1; major <= longest; ++major) {
        for (int minor = 0; minor <= major; ++minor) {
            for_each_cell(major, minor, 0, major, [&](int u, int v) {
                const int below = u * minor / major;
                ASSERT_TRUE(below - 1 <= v && v <= below + 2)
                    << "(" << u << ", " << v << ") of the segment to (" << major << ", " << minor << ")";
            });
        }
    }
}

TEST(InferredSight, TwoNeighboursCoverWhatLiesBeforeThem) {
    for (int major = 2; major <= longest; ++major) {
        for (int minor = 0; minor <= major; ++minor) {
            for (int k = 1; k <= furthest_line && k < major; ++k) {
                const int line = major - k;
                const int lower = line * minor / major;
                const bool between = line * minor % major != 0;
                for_each_cell(major, minor, 0, line - 1, [&](int u, int v) {
                    ASSERT_TRUE(in_strip(line, lower, u, v) || (between && in_strip(line, lower + 1, u, v)))
                        << "(" << u << ", " << v << ") of the segment to (" << major << ", " << minor << "), line "
                        << line;
                });
            }
        }
    }
}

}  // namespace
}  // namespace waybreaker
